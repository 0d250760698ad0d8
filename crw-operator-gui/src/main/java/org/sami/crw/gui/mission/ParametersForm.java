package org.sami.crw.gui.mission;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.value.JudgedDraft;
import org.sami.crw.gui.value.JudgementView;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.palette.SemanticColor;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Plan;
import org.sami.spn.value.Value;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.value.ValueField;

/**
 * The values with which a mission of a plan can start, each with the editor of its type; what is left out is asked as the mission goes. They are judged while
 * they are given, as answers are. On the event thread.
 */
final class ParametersForm extends JPanel {
    private static final int WIDTH = 560;
    private static final int HEIGHT = 420;
    private static final int STEP = 24;

    private final List<ParameterRow> rows = new ArrayList<>();
    private final DisabledNote disabled = new DisabledNote("mission-values-disabled");
    private final JLabel wrong = new JLabel(" ");
    private final JudgementView judgement = new JudgementView("mission-values");
    private final JudgedDraft judged;
    private final Consumer<Map<String, Value>> started;
    private boolean pressed;
    private final JButton start = new JButton("Start mission");
    private final Consumer<List<Value>> changed;

    /**
     * A form.
     *
     * @param names the parameters that are offered, those that are not locked
     * @param last the values of the last time, by name
     * @param judge judges values, by name, before the mission starts with them; on the event thread
     * @param changed is given the values that are ticked and complete, after each change
     * @param started is given the values, by name
     */
    ParametersForm(
            Parameters parameters,
            List<String> names,
            ValueEditors editors,
            Map<String, Value> last,
            Function<Map<String, Value>, CompletionStage<Judgement>> judge,
            Consumer<List<Value>> changed,
            Consumer<Map<String, Value>> started) {
        super(new MigLayout("insets 0, wrap 2, hidemode 3", "[grow, fill][]", "[grow, fill][][]"));
        setName("mission-values");
        this.changed = changed;
        this.started = started;
        judged = new JudgedDraft(() -> DraftAnswer.of(values()), draft -> judge.apply(draft.values()), this::rejudged);
        JPanel column = new JPanel(new MigLayout("insets 0, gap 4 8, fillx, wrap 1, hidemode 3", "[grow,fill]"));
        column.add(disabled, "wmin 0");
        for (Parameters.Description each : parameters.describe()) {
            if (each.editable() && names.contains(each.name())) {
                ValueField field = ValueField.of(
                        "start." + each.name(), parameters.type(each.name()).orElseThrow());
                String otherwise = each.preset().map(preset -> "is " + preset).orElse("is asked as the mission goes");
                ParameterRow row = new ParameterRow(
                        each.name(),
                        editors.editor(field),
                        otherwise,
                        Optional.ofNullable(last.get(each.name())),
                        this::check);
                rows.add(row);
                column.add(row);
            }
        }
        if (rows.isEmpty()) {
            column.add(new JLabel("This plan asks nothing at its start."));
        }
        LookColors.foreground(wrong, SemanticColor.CRITICAL);
        wrong.setName("mission-values-wrong");
        start.setName("mission-values-start");
        start.addActionListener(e -> press());
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "start");
        getActionMap().put("start", new Command("mission-values-enter", "Start mission", start::doClick));
        add(scrolled(column), "span");
        add(judgement, "span, wmin 0");
        add(wrong, "wmin 0");
        add(start, "hmin 40");
        check();
    }

    /** Says of the plan that is to start what it does that is disabled for trying. */
    void warnOf(Plan plan) {
        disabled.show(Optional.of(plan));
        disabled.reserve(!DisabledParts.warning(plan).isEmpty());
    }

    private static JScrollPane scrolled(JPanel column) {
        JScrollPane pane = new JScrollPane(
                column, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        pane.setBorder(null);
        pane.getVerticalScrollBar().setUnitIncrement(Look.px(STEP));
        pane.setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(HEIGHT)));
        return pane;
    }

    JButton startButton() {
        return start;
    }

    private Map<String, Value> values() {
        Map<String, Value> values = new LinkedHashMap<>();
        rows.forEach(row -> row.value().ifPresent(value -> values.put(row.parameter(), value)));
        return values;
    }

    private void check() {
        pressed = false;
        changed.accept(List.copyOf(values().values()));
        judged.look();
        tell();
    }

    private void rejudged() {
        boolean given = pressed && judged.isCurrent();
        tell();
        if (given) {
            pressed = false;
            if (start.isEnabled() && judged.judgement().doubts().isEmpty()) {
                started.accept(values());
            }
        }
    }

    /** Starts with judged values; with unjudged ones once they are judged, unless there is a warning. */
    private void press() {
        if (judged.isCurrent()) {
            started.accept(values());
        } else {
            pressed = true;
            judged.look();
        }
    }

    private void tell() {
        Optional<String> fault = rows.stream()
                .map(ParameterRow::wrong)
                .flatMap(Optional::stream)
                .findFirst()
                .or(() -> judged.isCurrent() ? judged.judgement().refusal() : Optional.empty());
        wrong.setText(fault.map(text -> "▲ " + text).orElse(" "));
        wrong.setToolTipText(fault.orElse(null));
        judgement.show(judged.judgement());
        start.setEnabled(fault.isEmpty());
        start.setToolTipText(fault.orElse("Start the mission with these values (Enter)"));
        revalidate();
    }
}
