package org.sami.spn.drawing.states;

import java.util.List;

/** Writes a graph in the language DOT of Graphviz, for tools that lay out larger graphs. */
public final class StateGraphDot {
    private StateGraphDot() {}

    /** The whole text. Every name is quoted; what would end a quotation is escaped. */
    public static String of(StateGraph graph) {
        StringBuilder text = new StringBuilder("digraph states {\n");
        text.append("  label=")
                .append(quoted(List.of(graph.title(), graph.remark())))
                .append(";\n");
        text.append("  node [shape=box, style=rounded];\n");
        for (int i = 0; i < graph.states().size(); i++) {
            StateGraph.State state = graph.states().get(i);
            text.append("  s").append(i).append(" [label=").append(quoted(lines(state)));
            text.append(i == 0 ? ", penwidth=2" : "").append(look(state.kind())).append("];\n");
        }
        for (StateGraph.Arrow arrow : graph.arrows()) {
            text.append("  s").append(arrow.from()).append(" -> s").append(arrow.to());
            text.append(" [label=").append(quoted(arrow.firings())).append("];\n");
        }
        return text.append("}\n").toString();
    }

    private static List<String> lines(StateGraph.State state) {
        return List.of(state.name(), String.join(" ", state.marked()));
    }

    private static String look(StateGraph.Kind kind) {
        return switch (kind) {
            case INNER -> "";
            case END -> ", peripheries=2";
            case DEADLOCK -> ", color=red, fontcolor=red";
            case NOT_FOLLOWED -> ", style=\"rounded,dashed\"";
        };
    }

    private static String quoted(List<String> lines) {
        List<String> escaped = lines.stream()
                .map(line -> line.replace("\\", "\\\\").replace("\"", "\\\"").replace('\n', ' '))
                .toList();
        return '"' + String.join("\\n", escaped) + '"';
    }
}
