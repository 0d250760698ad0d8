package org.sami.dreamm.query;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.PlanQuery;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Icons;
import org.sami.ui.look.LookColors;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** The plan's queries with their answers: a query is written and kept here, answered, its run shown. On the event thread. */
public final class QueriesView extends FoldingPanel {
    private static final List<String> COMMANDS = List.of(
            "query-all",
            "query-one",
            "query-happen",
            "query-stop",
            "query-show",
            "query-back",
            "query-next",
            "query-play",
            "query-remove",
            "query-graph",
            "query-bounds");

    private static final String TABLE = "table";
    private static final String GRAPH = "graph";
    private static final int NARROW = 640;

    /** Which button begins the second row in a narrow panel. */
    private static final int FIRST_BELOW = 4;

    private static final String BUTTON = "hmin 32, wmin 32";
    private static final String MESSAGE = "w 0, wmin 0, growx, pushx";
    private static final String MESSAGE_BELOW = "newline, span, w 100%, wmin 0";
    private static final String NAME = "cell 0 0, wmin 40, hmin 32";
    private static final String NAME_ABOVE = "cell 0 0 2 1, growx, wmin 40, hmin 32";
    private static final String TEXT = "cell 1 0, wmin 60, hmin 32";
    private static final String TEXT_BELOW = "cell 0 1 4 1, growx, wmin 60, hmin 32";

    private final transient DreammContext context;
    private final transient QueryAnswers answers;
    private final transient WitnessOnNet witness;
    private final transient QueryCommands commands;
    private final transient StatesOfPlan states;
    private final transient BoundsOfPlan bounds;
    private final transient CardLayout cards = new CardLayout();
    private final JPanel middle = new JPanel(cards);
    private final RowTable<QueryRow> table;
    private final JTextField name = new JTextField();
    private final JTextField text = new JTextField();
    private final JComboBox<String> expected = new JComboBox<>(new String[] {"yes", "no"});
    private final JButton keep = new JButton("Keep");
    private final JLabel message = new JLabel();
    private final transient List<JButton> buttons = new ArrayList<>();
    private final transient MigLayout buttonCells = new MigLayout("novisualpadding, insets 0, gap 6, hidemode 3");
    private final transient MigLayout draftCells =
            new MigLayout("novisualpadding, insets 0, gap 6", "[30%, fill][grow, fill][][]");

    /** The view of a window. */
    public QueriesView(
            DreammContext context,
            QueryAnswers answers,
            WitnessOnNet witness,
            QueryCommands commands,
            StatesOfPlan states,
            BoundsOfPlan bounds) {
        super(new BorderLayout());
        setName("queries-panel");
        this.context = context;
        this.answers = answers;
        this.witness = witness;
        this.commands = commands;
        this.states = states;
        this.bounds = bounds;
        table = new RowTable<>(
                "queries-table",
                "No query yet. Write one below, such as: reachable m(\"Go home\".robots) >= 1",
                row -> row.query().name(),
                List.of(
                        RowColumn.<QueryRow>words("Result", 96, QueryRow::word)
                                .withIcon(QueriesView::icon)
                                .colored(QueriesView::color),
                        RowColumn.words("Name", 0, row -> row.query().name()),
                        RowColumn.<QueryRow>words("Its answer, or what it asks", 0, QueryRow::words)
                                .colored(row -> SemanticColor.MUTED)));
        table.table().getAccessibleContext().setAccessibleName("Queries");
        middle.setOpaque(false);
        middle.add(table, TABLE);
        middle.add(new JScrollPane(new StatesPane(states)), GRAPH);
        add(middle);
        add(foot(), BorderLayout.SOUTH);
        table.addSelectionListener(this::selected);
        foldBelowWidth(NARROW, this::putTextBelow);
        commands.addAskListener(asked -> {
            table.selectKeys(Set.of(asked));
            selected();
        });
        answers.addListener(this::refresh);
        witness.addListener(this::refresh);
        states.addListener(this::refresh);
        bounds.addListener(this::refresh);
        refresh();
    }

    private static Optional<Icon> icon(QueryRow row) {
        return row.answer().isPresent()
                ? Optional.of(Icons.of(row.isGood() ? "check" : row.isBad() ? "close" : "help", 16, color(row)))
                : Optional.empty();
    }

    private static SemanticColor color(QueryRow row) {
        return row.isGood() ? SemanticColor.OK : row.isBad() ? SemanticColor.CRITICAL : SemanticColor.MUTED;
    }

    private JPanel foot() {
        JPanel foot = new JPanel(new MigLayout("novisualpadding, insets 4 8 4 8, gap 6, wrap 1", "[grow, fill]", ""));
        foot.setOpaque(false);
        JPanel draft = new JPanel(draftCells);
        draft.setOpaque(false);
        named(name, "query-name", "Name", "Name of the query to keep");
        named(text, "query-text", "reachable m(place.robots) >= 1", "What the query asks");
        text.setToolTipText("reachable, invariant or home CONDITION; deadlock; bound PLACE.robots");
        expected.setName("query-expected");
        expected.setToolTipText("The answer that is expected; another one is a finding");
        expected.getAccessibleContext().setAccessibleName("Expected answer");
        keep.setName("query-keep");
        keep.addActionListener(e -> keep());
        text.addActionListener(e -> keep());
        name.addActionListener(e -> text.requestFocusInWindow());
        draft.add(name, NAME);
        draft.add(text, TEXT);
        draft.add(expected, "cell 2 0, hmin 32");
        draft.add(keep, "cell 3 0, hmin 32");
        foot.add(draft, "wmin 0");
        JPanel row = new JPanel(buttonCells);
        row.setOpaque(false);
        for (String id : COMMANDS) {
            context.commands().find(id).map(CommandButton::iconOnly).ifPresent(button -> {
                buttons.add(button);
                row.add(button, BUTTON);
            });
        }
        message.setName("queries-message");
        row.add(message, MESSAGE);
        foot.add(row, "wmin 0");
        return foot;
    }

    /** In a narrow panel the question and the answer have rows of their own, and buttons stand in two. */
    private void putTextBelow(boolean below) {
        draftCells.setComponentConstraints(name, below ? NAME_ABOVE : NAME);
        draftCells.setComponentConstraints(text, below ? TEXT_BELOW : TEXT);
        buttonCells.setComponentConstraints(buttons.get(FIRST_BELOW), below ? BUTTON + ", newline" : BUTTON);
        buttonCells.setComponentConstraints(message, below ? MESSAGE_BELOW : MESSAGE);
    }

    private static void named(JTextField field, String id, String placeholder, String words) {
        field.setName(id);
        field.putClientProperty("JTextField.placeholderText", placeholder);
        field.getAccessibleContext().setAccessibleName(words);
    }

    /** Puts the selected query into the fields, to be changed. */
    private void selected() {
        Optional<PlanQuery> query = table.selected().map(QueryRow::query);
        commands.select(query.map(PlanQuery::name));
        query.ifPresent(chosen -> {
            name.setText(chosen.name());
            text.setText(chosen.text());
            expected.setSelectedIndex(chosen.expected() == PlanQuery.Expected.YES ? 0 : 1);
        });
    }

    private void keep() {
        String called = name.getText().strip();
        String asked = text.getText().strip();
        if (called.isEmpty() || asked.isEmpty()) {
            context.notices().refused("a query has a name and a text, such as reachable m(visit) >= 1");
            return;
        }
        commands.keep(new PlanQuery(
                called, asked, expected.getSelectedIndex() == 0 ? PlanQuery.Expected.YES : PlanQuery.Expected.NO));
        table.selectKeys(Set.of(called));
        selected();
    }

    private void refresh() {
        table.show(answers.rows());
        commands.select(table.selected().map(row -> row.query().name()));
        cards.show(middle, states.isShown() ? GRAPH : TABLE);
        String words = states.isShown() || !states.words().isEmpty()
                ? states.words()
                : !bounds.words().isEmpty()
                        ? bounds.words()
                        : witness.words().isEmpty()
                                ? answers.isRunning()
                                        ? answers.message()
                                        : table.selected()
                                                .filter(row -> row.answer().isPresent())
                                                .map(QueryRow::words)
                                                .orElse(answers.message())
                                : witness.words();
        message.setText(words.isEmpty() ? " " : words);
        message.setToolTipText(words.isEmpty() ? null : words);
        LookColors.foreground(message, SemanticColor.MUTED);
        LookColors.background(this, SemanticColor.SURFACE);
    }
}
