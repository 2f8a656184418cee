#include "app/bench/report.hpp"

#include "app/bench/machine.hpp"
#include "core/base/version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hs::bench {
namespace {

std::string number(const std::optional<double>& value) {
    return value ? fmt::format("{:.3g}", *value) : std::string{};
}

std::string with_unit(double value, const std::string& unit) {
    return fmt::format("{:.4g} {}", value, unit);
}

std::string budget_text(const Measurement& m) {
    if (!m.budget) {
        return {};
    }
    return m.peer.empty() ? "≤ " + with_unit(*m.budget, m.unit)
                          : fmt::format("≤ {:.3g}×", *m.budget);
}

std::string verdict(const Measurement& m) {
    const std::optional<bool> holds = m.holds();
    return !holds ? "" : *holds ? "holds" : "OPEN";
}

std::string peer_text(const Measurement& m) {
    if (m.peer.empty()) {
        return {};
    }
    return m.peer_value ? fmt::format("{} {}", m.peer, with_unit(*m.peer_value, m.unit))
                        : m.peer + " absent";
}

nlohmann::ordered_json to_object(const Measurement& m) {
    nlohmann::ordered_json object{{"name", m.name}, {"value", m.value}, {"unit", m.unit}};
    if (!m.peer.empty()) {
        object["peer"] = m.peer;
    }
    if (m.peer_value) {
        object["peer_value"] = *m.peer_value;
        object["ratio"] = *m.ratio();
    }
    if (m.budget) {
        object["budget"] = *m.budget;
    }
    if (m.holds()) {
        object["holds"] = *m.holds();
    }
    if (!m.note.empty()) {
        object["note"] = m.note;
    }
    return object;
}

} // namespace

std::string to_table(const Results& results) {
    constexpr std::string_view row = "{:<27} {:>12}  {:<20} {:>6}  {:<12} {}\n";
    const Machine machine = this_machine();
    std::string text = fmt::format(
        "{}, {} threads, {}; load {:.1f}\n\n",
        machine.processor,
        machine.threads,
        machine.compiler,
        machine.load
    );
    text += fmt::format(fmt::runtime(row), "", "value", "peer", "ratio", "budget", "");
    for (const Measurement& m : results.measurements) {
        text += fmt::format(
            fmt::runtime(row),
            m.name,
            with_unit(m.value, m.unit),
            peer_text(m),
            number(m.ratio()),
            budget_text(m),
            verdict(m)
        );
    }
    for (const std::string& sentence : results.remarks) {
        text += "\n" + sentence + "\n";
    }
    return text;
}

std::string to_json(const Results& results) {
    const Machine machine = this_machine();
    nlohmann::ordered_json document;
    document["program"] = program_version();
    document["machine"] = {
        {"processor", machine.processor},
        {"threads", machine.threads},
        {"compiler", machine.compiler},
        {"load", machine.load}};
    document["results"] = nlohmann::ordered_json::array();
    for (const Measurement& m : results.measurements) {
        document["results"].push_back(to_object(m));
    }
    document["remarks"] = results.remarks;
    return document.dump(2) + "\n";
}

} // namespace hs::bench
