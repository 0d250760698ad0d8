package org.sami.dreamm.tryout;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.stepping.Stepper;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.value.ValueSummary;

/** What stands where in all missions of the run, and what its variables hold. */
final class StateView extends JPanel {
    private final transient DreammContext context;
    private final transient TryOut tryOut;
    private final RowTable<Row> table;

    private record Row(String key, String where, String what, String holds) {}

    StateView(DreammContext context, TryOut tryOut) {
        super(new BorderLayout());
        this.context = context;
        this.tryOut = tryOut;
        table = new RowTable<>(
                "try-state",
                "Nothing is tried: no tokens, no values.",
                Row::key,
                List.of(
                        RowColumn.<Row>words("Plan", 110, Row::where).colored(row -> SemanticColor.MUTED),
                        RowColumn.words("Place or variable", 150, Row::what),
                        RowColumn.words("Tokens or value", 0, Row::holds)));
        add(table);
        tryOut.addListener(this::refresh);
        refresh();
    }

    private void refresh() {
        List<Row> rows = new ArrayList<>();
        tryOut.stepper().ifPresent(stepper -> stepper.view().missions().forEach(m -> rows(stepper, m, rows)));
        table.show(rows);
    }

    private void rows(Stepper stepper, MissionView mission, List<Row> rows) {
        String key = mission.id() + " ";
        Optional<Plan> plan = stepper.view().planOf(mission.id());
        String title = plan.map(Plan::title).orElse(mission.plan());
        mission.marking().forEach((place, tokens) -> {
            String name = plan.flatMap(of -> new ElementNames(of, context.vocabulary()).of(place))
                    .orElse(place);
            rows.add(new Row(key + place, title, name, StepWords.tokens(tokens)));
        });
        List<VariableSpec> variables = new ArrayList<>(plan.map(Plan::variables).orElse(List.of()));
        if (mission.id() == stepper.mission()) {
            variables.addAll(context.document().project().globals());
        }
        for (VariableSpec variable : variables) {
            String value = stepper.view()
                    .variable(mission.id(), variable.name())
                    .map(ValueSummary::of)
                    .orElse("no value yet");
            rows.add(new Row(key + variable.name(), title, variable.name(), value));
        }
    }
}
