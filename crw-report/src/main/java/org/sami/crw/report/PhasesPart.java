package org.sami.crw.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * How far missions came by their phase charts.
 *
 * @param actions of missions whose plans have a chart, in the order of missions and of each chart
 */
public record PhasesPart(List<PhaseResult> actions) implements ReportPart {
    public PhasesPart {
        actions = List.copyOf(actions);
    }

    @Override
    public String name() {
        return "phases";
    }

    @Override
    public List<?> json() {
        return actions;
    }

    /** A line for each phase, with what was executed in brackets. */
    @Override
    public List<String> lines() {
        Map<String, List<String>> phases = new LinkedHashMap<>();
        for (PhaseResult action : actions) {
            String words = action.label()
                    + switch (action.status()) {
                        case "ahead" -> "";
                        case "active" -> " [under way]";
                        default -> action.executions() > 1 ? " [" + action.executions() + " times]" : " [done]";
                    };
            phases.computeIfAbsent("mission " + action.mission() + ", " + action.phase(), phase -> new ArrayList<>())
                    .add(words);
        }
        List<String> lines = new ArrayList<>();
        phases.forEach((phase, words) -> lines.add("  " + phase + ": " + String.join("; ", words)));
        if (!lines.isEmpty()) {
            lines.add(0, "phases");
        }
        return lines;
    }

    @Override
    public List<String> columns() {
        return List.of("mission", "plan", "phase", "actor", "action", "status", "executions");
    }

    @Override
    public List<List<Object>> rows() {
        return actions.stream()
                .map(action -> List.<Object>of(
                        action.mission(),
                        action.plan(),
                        action.phase(),
                        action.actor(),
                        action.label(),
                        action.status(),
                        action.executions()))
                .toList();
    }
}
