package org.sami.crw.cli.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseView;

/** A phase chart as a table for a terminal: a row for each actor, time to the right. */
final class PhaseText {
    private static final String GAP = "  ";

    private final PhaseChart chart;
    private final Map<String, String> chosen;

    PhaseText(PhaseChart chart, Map<String, String> chosen) {
        this.chart = chart;
        this.chosen = chosen;
    }

    /** All phases, one after another. */
    String text() {
        StringBuilder text = new StringBuilder();
        for (String phase : chart.phases()) {
            append(text, chart.view(phase, chosen));
        }
        return text.toString();
    }

    private void append(StringBuilder text, PhaseView view) {
        text.append(view.phase()).append('\n');
        List<List<String>> rows = new ArrayList<>();
        for (String actor : view.actors()) {
            rows.add(new ArrayList<>(List.of(GAP + actor)));
        }
        int columns =
                1 + view.boxes().stream().mapToInt(PhaseView.Box::column).max().orElse(-1);
        for (int column = 0; column < columns; column++) {
            for (int row = 0; row < rows.size(); row++) {
                rows.get(row).add(cell(view, row, column));
            }
        }
        int[] widths = new int[columns + 1];
        rows.forEach(row -> {
            for (int i = 0; i < row.size(); i++) {
                widths[i] = Math.max(widths[i], row.get(i).length());
            }
        });
        for (List<String> row : rows) {
            StringBuilder line = new StringBuilder();
            for (int i = 0; i < row.size(); i++) {
                line.append(row.get(i))
                        .append(" ".repeat(widths[i] - row.get(i).length()))
                        .append(GAP);
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        for (PhaseView.Box box : view.boxes()) {
            if (!box.options().isEmpty()) {
                text.append(GAP)
                        .append(box.action().label())
                        .append(": ")
                        .append(options(box))
                        .append('\n');
            }
        }
        text.append(GAP)
                .append(view.next().isEmpty() ? "then no other phase" : "then " + String.join(" or ", view.next()))
                .append("\n\n");
    }

    private static String cell(PhaseView view, int row, int column) {
        List<String> labels = view.boxes().stream()
                .filter(box -> box.row() == row && box.column() == column)
                .map(box -> "[" + box.action().label() + "]")
                .toList();
        return String.join(" ", labels);
    }

    private static String options(PhaseView.Box box) {
        List<String> options = new ArrayList<>();
        for (PhaseAction option : box.options()) {
            options.add(option.id().equals(box.chosen()) ? option.label() + " (shown)" : option.label());
        }
        return String.join(" | ", options);
    }
}
