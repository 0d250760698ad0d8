package org.sami.ui.value;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import javax.swing.JComponent;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/** What a solution says of each of its entries, such as a robot and how long its way is, which becomes known later. On the event thread. */
final class SolutionLines {
    private final Value solution;
    private final Map<String, WrappedText> texts = new HashMap<>();
    private final Map<RobotPath, List<GeoPoint>> known = new HashMap<>();

    private SolutionLines(Value solution) {
        this.solution = solution;
    }

    /**
     * Adds the lines of a solution to a panel of two columns.
     *
     * @param ways of its robots
     */
    static void add(JComponent panel, Value solution, RobotWays ways) {
        SolutionLines lines = new SolutionLines(solution);
        Figures.of(solution).lines().forEach((label, text) -> lines.texts.put(label, line(panel, label, text)));
        Figures.paths(solution)
                .forEach(path -> ways.find(path.robot(), path.path(), way -> {
                    lines.known.put(path, way);
                    lines.refresh();
                }));
    }

    /** Adds one line. */
    static WrappedText line(JComponent panel, String label, String text) {
        WrappedText words = new WrappedText(text);
        panel.add(new NoteLabel(label), "aligny top");
        panel.add(words, "wmin 60");
        return words;
    }

    private void refresh() {
        Figures.of(solution, known).lines().forEach((label, text) -> {
            WrappedText line = Objects.requireNonNull(texts.get(label), label);
            if (!line.getText().equals(text)) {
                line.setText(text);
            }
        });
    }
}
