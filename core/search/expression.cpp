// Lua runs in a state of its own. Its errors are long jumps: between a call that can fail and the
// protected call around it, no C++ object may wait for its destructor, and no C++ exception may
// leave a function that Lua calls.
#include "core/search/expression.hpp"

#include "core/base/spelling.hpp"

#include <fmt/format.h>
#include <lua.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>

namespace hs::search {
namespace {

constexpr std::size_t most_bytes = std::size_t{8} << 20U;
constexpr int most_operations = 100'000; ///< of the virtual machine, for one answer

constexpr const char* chunk_name = "expression";

/// The state's memory: realloc, up to a limit.
struct Memory {
    std::size_t used = 0;

    static void* allocate(void* self, void* block, std::size_t before, std::size_t after) {
        Memory& memory = *static_cast<Memory*>(self);
        const std::size_t held = block == nullptr ? 0 : before; // else `before` is a kind of object
        if (after == 0) {
            std::free(block);
            memory.used -= held;
            return nullptr;
        }
        if (memory.used - held + after > most_bytes) {
            return nullptr;
        }
        void* const moved = std::realloc(block, after);
        if (moved != nullptr) {
            memory.used += after - held;
        }
        return moved;
    }
};

void too_many_operations(lua_State* lua, lua_Debug*) {
    luaL_error(
        lua,
        "stopped after %d operations; an expression is one comparison, not a loop",
        most_operations
    );
}

/// "expression:1: message" as a diagnostic.
Diagnostic located(std::string_view message) {
    Diagnostic result{.file = chunk_name, .message = std::string{message}};
    const std::string prefix = fmt::format("{}:", chunk_name);
    if (message.starts_with(prefix)) {
        const char* const begin = message.data() + prefix.size();
        const char* const end = message.data() + message.size();
        const auto [after, error] = std::from_chars(begin, end, result.line);
        if (error == std::errc{} && end - after > 2) {
            result.message.assign(after + 2, end);
        }
    }
    return result;
}

/// What people who know other languages write, and what Lua calls it.
std::string hint_for(std::string_view text) {
    constexpr std::array<std::array<std::string_view, 2>, 4> habits{
        {{"!=", "'not equal' is written ~="},
         {"&&", "'&&' is written and"},
         {"||", "'||' is written or"},
         {"!", "'!' is written not"}}};
    for (const auto& [wrong, right] : habits) {
        if (text.find(wrong) != std::string_view::npos) {
            return fmt::format("; {}", right);
        }
    }
    return text.find("==") == std::string_view::npos && text.find('=') != std::string_view::npos
               ? "; 'equal' is written =="
               : "";
}

} // namespace

/// The Lua state, and the names its expression reads.
class Expression::Machine {
public:
    explicit Machine(std::vector<Name> names)
        : names_(std::move(names)), lua_(lua_newstate(&Memory::allocate, &memory_)) {}
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;
    Machine(Machine&&) = delete;
    Machine& operator=(Machine&&) = delete;
    ~Machine() {
        if (lua_ != nullptr) {
            lua_close(lua_);
        }
    }

    std::optional<Diagnostic> load(std::string_view text);
    std::optional<Diagnostic> check_words(std::string_view text);
    Result<bool> ask();
    [[nodiscard]] const std::vector<std::size_t>& mentioned() const { return mentioned_; }

private:
    static Machine& of(lua_State* lua) { return **static_cast<Machine**>(lua_getextraspace(lua)); }
    static int set_up(lua_State* lua);
    static int read_name(lua_State* lua);
    static int refuse_global(lua_State* lua);

    [[nodiscard]] std::vector<std::string_view> paths() const;
    [[nodiscard]] std::optional<Diagnostic> check_name(const std::string& word);
    [[nodiscard]] std::optional<Diagnostic> check_text(const std::string& word) const;
    /// Takes the error message from the top of the stack.
    Diagnostic take_error();

    std::vector<Name> names_;
    std::vector<std::size_t> mentioned_;
    Memory memory_;
    lua_State* lua_;
};

// Names: `fragment.pixel.x` is a table `fragment` with a table `pixel` whose `x` is asked for when
// it is needed. A table keeps its leaves beside it, as indices into `names_`.

namespace {

/// Pushes one part of a path: an index as a number, all else as text.
void push_part(lua_State* lua, std::string_view part) {
    lua_Integer index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error == std::errc{} && end == part.data() + part.size()) {
        lua_pushinteger(lua, index);
    } else {
        lua_pushlstring(lua, part.data(), part.size());
    }
}

/// Leaves a new table on the stack whose unknown fields are answered by `read`.
void push_group(lua_State* lua, std::string_view path, lua_CFunction read) {
    lua_newtable(lua); // the group
    lua_newtable(lua); // its metatable
    lua_newtable(lua); // its leaves
    lua_pushvalue(lua, -1);
    lua_setfield(lua, -3, "leaves");
    lua_pushlstring(lua, path.data(), path.size());
    lua_pushcclosure(lua, read, 2);
    lua_setfield(lua, -2, "__index");
    lua_setmetatable(lua, -2);
}

/// Files `path` as leaf number `leaf`, making the groups it goes through.
void add_leaf(lua_State* lua, std::string_view path, lua_Integer leaf, lua_CFunction read) {
    lua_pushglobaltable(lua);
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != std::string_view::npos;
         dot = path.find('.', begin)) {
        push_part(lua, path.substr(begin, dot - begin));
        if (lua_rawget(lua, -2) == LUA_TNIL) {
            lua_pop(lua, 1);
            push_group(lua, path.substr(0, dot), read);
            push_part(lua, path.substr(begin, dot - begin));
            lua_pushvalue(lua, -2);
            lua_rawset(lua, -4);
        }
        lua_remove(lua, -2); // the table it stands in
        begin = dot + 1;
    }
    luaL_getmetafield(lua, -1, "leaves");
    push_part(lua, path.substr(begin));
    lua_pushinteger(lua, leaf);
    lua_rawset(lua, -3);
    lua_pop(lua, 2);
}

} // namespace

int Expression::Machine::set_up(lua_State* lua) {
    luaL_requiref(lua, "math", luaopen_math, 1);
    for (const char* name : {"random", "randomseed"}) { // the same question has the same answer
        lua_pushnil(lua);
        lua_setfield(lua, -2, name);
    }
    lua_pop(lua, 1);
    const std::vector<Name>& names = of(lua).names_;
    for (std::size_t i = 0; i < names.size(); ++i) {
        add_leaf(lua, names[i].path, static_cast<lua_Integer>(i), &Machine::read_name);
    }
    lua_pushglobaltable(lua);
    lua_newtable(lua);
    lua_pushcfunction(lua, &Machine::refuse_global);
    lua_setfield(lua, -2, "__index");
    lua_setmetatable(lua, -2);
    return 0;
}

int Expression::Machine::read_name(lua_State* lua) {
    lua_pushvalue(lua, 2);
    if (lua_rawget(lua, lua_upvalueindex(1)) == LUA_TNIL) {
        return luaL_error(
            lua,
            "there is no %s.%s",
            lua_tostring(lua, lua_upvalueindex(2)),
            luaL_tolstring(lua, 2, nullptr)
        );
    }
    const auto leaf = static_cast<std::size_t>(lua_tointeger(lua, -1));
    bool failed = false;
    Value value;
    try {
        value = of(lua).names_[leaf].read();
    } catch (...) {
        failed = true; // and reported outside, where no exception is alive
    }
    if (failed) {
        return luaL_error(lua, "a value could not be computed: not enough memory");
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        lua_pushinteger(lua, *whole);
    } else if (const auto* real = std::get_if<double>(&value)) {
        lua_pushnumber(lua, *real);
    } else {
        const auto text = std::get<std::string_view>(value);
        lua_pushlstring(lua, text.data(), text.size());
    }
    return 1;
}

int Expression::Machine::refuse_global(lua_State* lua) {
    return luaL_error(lua, "there is no '%s'", luaL_tolstring(lua, 2, nullptr));
}

// Loading: words are checked before Lua sees them, since `a or b` may never ask for b

std::vector<std::string_view> Expression::Machine::paths() const {
    std::vector<std::string_view> all;
    for (const Name& name : names_) {
        all.emplace_back(name.path);
    }
    return all;
}

std::optional<Diagnostic> Expression::Machine::check_name(const std::string& word) {
    const std::string group = word.substr(0, word.find('.')) + '.';
    bool known_group = false;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (names_[i].path == word) {
            if (std::ranges::find(mentioned_, i) == mentioned_.end()) {
                mentioned_.push_back(i);
            }
            return std::nullopt;
        }
        known_group = known_group || names_[i].path.starts_with(group);
    }
    if (!known_group) {
        return std::nullopt; // a keyword, math, a local name; else Lua will complain
    }
    const std::vector<std::string_view> known = paths();
    return Diagnostic{
        .file = chunk_name,
        .message = fmt::format("there is no {}{}", word, did_you_mean(word, known))};
}

std::optional<Diagnostic> Expression::Machine::check_text(const std::string& word) const {
    std::vector<std::string_view> possible;
    for (const std::size_t i : mentioned_) {
        possible.insert(possible.end(), names_[i].meanings.begin(), names_[i].meanings.end());
    }
    if (std::ranges::find(possible, word) != possible.end()) {
        return std::nullopt;
    }
    if (possible.empty()) {
        return Diagnostic{
            .file = chunk_name,
            .message = fmt::format("nothing named here is ever the text \"{}\"", word)};
    }
    return Diagnostic{
        .file = chunk_name,
        .message = fmt::format(
            "nothing named here is ever \"{}\"; there are {}", word, list_of_choices(possible)
        )};
}

std::optional<Diagnostic> Expression::Machine::check_words(std::string_view text) {
    const Words words = words_of(text);
    for (const std::string& name : words.names) {
        if (auto problem = check_name(name)) {
            return problem;
        }
    }
    for (const std::string& word : words.texts) {
        if (auto problem = check_text(word)) {
            return problem;
        }
    }
    return std::nullopt;
}

Diagnostic Expression::Machine::take_error() {
    const char* const message = lua_tostring(lua_, -1);
    Diagnostic result = located(message == nullptr ? "failed without saying why" : message);
    lua_pop(lua_, 1);
    return result;
}

std::optional<Diagnostic> Expression::Machine::load(std::string_view text) {
    if (lua_ == nullptr) {
        return Diagnostic{.file = chunk_name, .message = "not enough memory"};
    }
    *static_cast<Machine**>(lua_getextraspace(lua_)) = this;
    lua_pushcfunction(lua_, &Machine::set_up);
    if (lua_pcall(lua_, 0, 0, 0) != LUA_OK) {
        return take_error();
    }
    const std::string chunk = fmt::format("return {}", text);
    const std::string name = fmt::format("={}", chunk_name);
    if (luaL_loadbufferx(lua_, chunk.data(), chunk.size(), name.c_str(), "t") != LUA_OK) {
        Diagnostic problem = take_error();
        problem.message += hint_for(text);
        return problem;
    }
    return std::nullopt;
}

Result<bool> Expression::Machine::ask() {
    lua_sethook(lua_, too_many_operations, LUA_MASKCOUNT, most_operations);
    lua_pushvalue(lua_, 1); // the loaded chunk stays where it is
    if (lua_pcall(lua_, 0, 1, 0) != LUA_OK) {
        return take_error();
    }
    if (!lua_isboolean(lua_, -1)) {
        const std::string kind = luaL_typename(lua_, -1);
        lua_pop(lua_, 1);
        return Diagnostic{
            .file = chunk_name,
            .message = fmt::format(
                "the answer is a {}, not true or false; compare it with something", kind
            )};
    }
    const bool answer = lua_toboolean(lua_, -1) != 0;
    lua_pop(lua_, 1);
    return answer;
}

Result<Expression> Expression::compile(std::string_view text, std::vector<Name> names) {
    if (text.size() > longest) {
        return Diagnostic{
            .file = chunk_name,
            .message =
                fmt::format("has {} bytes; expressions have at most {}", text.size(), longest)};
    }
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        return Diagnostic{
            .file = chunk_name,
            .message = "is empty; write a comparison such as fragment.depth < 0.5"};
    }
    auto machine = std::make_unique<Machine>(std::move(names));
    if (auto problem = machine->check_words(text)) {
        return *problem;
    }
    if (auto problem = machine->load(text)) {
        return *problem;
    }
    return Expression(std::move(machine));
}

Expression::Expression(std::unique_ptr<Machine> machine) : machine_(std::move(machine)) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

Result<bool> Expression::operator()() {
    return machine_->ask();
}

const std::vector<std::size_t>& Expression::mentioned() const {
    return machine_->mentioned();
}

} // namespace hs::search
