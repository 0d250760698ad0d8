package org.sami.dreamm.tryout;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.ProjectEdit;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Icons;
import org.sami.ui.look.LookColors;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** The plan's saved test cases with what each came to; a run is kept here, played again, removed. */
final class SavedCasesView extends JPanel {
    private final transient DreammContext context;
    private final transient TryOut tryOut;
    private final transient SavedCases cases;
    private final RowTable<CaseResult> table;
    private final JTextField name = new JTextField();
    private final JButton keep = new JButton("Keep run");
    private final JButton play = new JButton("Play");
    private final JButton remove = new JButton("Remove");
    private final JLabel message = new JLabel();

    SavedCasesView(DreammContext context, TryOut tryOut, SavedCases cases) {
        super(new BorderLayout());
        this.context = context;
        this.tryOut = tryOut;
        this.cases = cases;
        table = new RowTable<>(
                "saved-cases",
                "No saved case yet. Try the plan and keep the run: what stands where at its end is what is expected then.",
                result -> result.test().name(),
                List.of(
                        RowColumn.<CaseResult>words("Result", 96, CaseResult::word)
                                .withIcon(SavedCasesView::icon)
                                .colored(SavedCasesView::color),
                        RowColumn.words("Name", 0, result -> result.test().name()),
                        RowColumn.<CaseResult>words(
                                        "Why it failed, or what it does",
                                        0,
                                        result -> result.failure().orElse(SavedCases.words(result.test())))
                                .colored(result -> SemanticColor.MUTED)));
        add(table);
        add(foot(), BorderLayout.SOUTH);
        table.addSelectionListener(this::refresh);
        cases.addListener(this::refresh);
        tryOut.addListener(this::refresh);
        refresh();
    }

    private static Optional<Icon> icon(CaseResult result) {
        return result.ran()
                ? Optional.of(Icons.of(result.failure().isEmpty() ? "check" : "close", 16, color(result)))
                : Optional.empty();
    }

    private static SemanticColor color(CaseResult result) {
        return !result.ran()
                ? SemanticColor.MUTED
                : result.failure().isEmpty() ? SemanticColor.OK : SemanticColor.CRITICAL;
    }

    private JPanel foot() {
        JPanel foot = new JPanel(new MigLayout("insets 4 8 4 8, gap 6", "[grow, fill][][][][]", "[][]"));
        foot.setOpaque(false);
        name.setName("case-name");
        name.putClientProperty("JTextField.placeholderText", "Name of the run to keep");
        name.getAccessibleContext().setAccessibleName("Name of the run to keep");
        name.addActionListener(e -> keep());
        keep.setName("case-keep");
        keep.addActionListener(e -> keep());
        play.setName("case-play");
        play.setToolTipText("Begins as the selected case does and takes its steps");
        play.addActionListener(e -> table.selected()
                .ifPresent(row -> context.editor().planId().ifPresent(plan -> tryOut.play(plan, row.test()))));
        remove.setName("case-remove");
        remove.addActionListener(e -> table.selected()
                .ifPresent(row -> context.editor()
                        .planId()
                        .ifPresent(plan -> context.apply(
                                new ProjectEdit.SetTestCase(plan, row.test().name(), Optional.empty())))));
        foot.add(name, "wmin 60, hmin 32");
        foot.add(keep, "hmin 32");
        foot.add(play, "hmin 32");
        foot.add(remove, "hmin 32");
        foot.add(new CommandButton(context.commands().get("try-cases")), "hmin 32, wrap");
        message.setName("cases-message");
        foot.add(message, "span 3, wmin 0, growx");
        foot.add(new CommandButton(context.commands().get("try-coverage")), "span 2, hmin 32, alignx right");
        return foot;
    }

    private void keep() {
        Optional<String> plan = tryOut.plan();
        if (plan.isEmpty() || whyNotKeep().isPresent()) {
            whyNotKeep().ifPresent(context.notices()::refused);
            return;
        }
        String called =
                name.getText().strip().isEmpty() ? "as tried" : name.getText().strip();
        EditResult result =
                context.apply(SavedCases.keeping(plan.get(), tryOut.stepper().orElseThrow(), called));
        if (result instanceof EditResult.Done) {
            name.setText("");
        }
    }

    private Optional<String> whyNotKeep() {
        return tryOut.stepper().isEmpty()
                ? Optional.of("nothing is tried: Start (F5) begins")
                : tryOut.isOutdated()
                        ? Optional.of("the plan has changed since the run began: Restart (Ctrl+F5) first")
                        : tryOut.disabled() > 0
                                ? Optional.of(
                                        "the run left out what is disabled for trying; a test case runs the whole plan")
                                : tryOut.stepper().get().whyNotATestCase();
    }

    private void refresh() {
        table.show(cases.cases());
        message.setText(cases.message());
        message.setToolTipText(cases.message().isEmpty() ? null : cases.message());
        LookColors.foreground(message, SemanticColor.MUTED);
        Optional<String> why = whyNotKeep();
        keep.setEnabled(why.isEmpty());
        keep.setToolTipText(
                why.orElse("Keeps the run as a test case of the plan; what stands where now is expected at its end"));
        play.setEnabled(table.selected().isPresent());
        remove.setEnabled(table.selected().isPresent());
    }
}
