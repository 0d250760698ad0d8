package org.sami.dreamm.compare;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.Plan;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.net.NetView;
import org.sami.ui.value.WrappedText;

/** Two versions of the open plan on one net, with a list of what differs; a chosen line is shown on the net. */
public final class ComparisonPanel extends JPanel {
    private static final String NOTHING = "No version is compared";
    private static final String HINT =
            "Here the open plan and another version of it stand on one net, with a list of what differs. Compare with what was "
                    + "saved, or with a file.";
    private static final String EMPTY = "empty";
    private static final String BOTH = "both";

    private final transient DreammContext context;
    private final NetView view = new NetView(new ProxyMarks());
    private final JLabel title = new JLabel(NOTHING);
    private final DefaultListModel<Difference> rows = new DefaultListModel<>();
    private final JList<Difference> list = new JList<>(rows);
    private final CardLayout cards = new CardLayout();
    private final JPanel deck = new JPanel(cards);
    private final JPanel empty =
            new JPanel(new MigLayout("novisualpadding, fill, insets " + Spacing.WIDE, "[grow, fill]", "[]"));
    private final List<CommandButton> versions;
    private transient Optional<Compared> compared = Optional.empty();
    private boolean solution;
    private transient Optional<PlanComparison> comparison = Optional.empty();

    /** With which version of which plan the open one is compared. */
    private record Compared(Plan before, String name) {}

    /** The panel of a window, which registers its commands. */
    public ComparisonPanel(DreammContext context) {
        super(new BorderLayout());
        this.context = context;
        setName("comparison");
        CompareCommands commands = new CompareCommands(context, this::compare);
        CommandRow row = new CommandRow();
        row.setName("comparison-tools");
        title.setName("comparison-title");
        title.setToolTipText(
                "Shows the open plan and another version of it on one net: as it was saved, or from another file");
        row.left(title);
        versions = List.of(new CommandButton(commands.saved()), new CommandButton(commands.file()));
        versions.forEach(row::right);
        list.setName("comparison-differences");
        list.getAccessibleContext().setAccessibleName("What differs");
        list.addListSelectionListener(e -> showChosen());
        view.setName("comparison-net");
        view.canvas().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                view.fit();
            }
        });
        JSplitPane split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, view, new JScrollPane(list));
        split.setResizeWeight(0.7);
        split.setBorder(BorderFactory.createEmptyBorder());
        WrappedText hint = new WrappedText(HINT);
        hint.setName("comparison-empty");
        hint.setColor(SemanticColor.MUTED);
        empty.add(hint, "wmin 0, growx");
        empty.setOpaque(false);
        deck.setOpaque(false);
        deck.add(empty, EMPTY);
        deck.add(split, BOTH);
        add(row, BorderLayout.NORTH);
        add(deck);
        context.document().addListener(change -> refresh());
        style();
    }

    /** Compares the open plan with a version of it. */
    public void compare(Plan before, String name) {
        compare(before, name, false);
    }

    /** Compares the open plan of a learner with a right one, and with nothing else. */
    public void compareWithSolution(Plan solution) {
        compare(solution, "the solution", true);
    }

    /** Has the keys in the list of what differs. */
    public void focusDifferences() {
        list.requestFocusInWindow();
    }

    private void compare(Plan before, String name, boolean isSolution) {
        solution = isSolution;
        versions.forEach(button ->
                button.setVisible(!isSolution && button.getAction() instanceof Command shown && !shown.isHidden()));
        compared = Optional.of(new Compared(before, name));
        showDifferences(true);
    }

    private void refresh() {
        if (isShowing()) {
            showDifferences(false);
        }
    }

    /** Marks what the chosen line is about, and shows it as large as words are read. */
    private void showChosen() {
        Set<String> elements = Optional.ofNullable(list.getSelectedValue())
                .map(Difference::elements)
                .orElse(Set.of());
        view.highlight(elements);
        comparison.ifPresent(shown -> view.revealReadable(shown.vertices(elements)));
    }

    private void showDifferences(boolean anew) {
        Optional<Plan> after =
                compared.flatMap(c -> context.document().plan(c.before().id()));
        if (after.isEmpty()) {
            title.setText(NOTHING);
            comparison = Optional.empty();
            rows.clear();
            cards.show(deck, EMPTY);
            return;
        }
        cards.show(deck, BOTH);
        PlanComparison now = PlanComparison.of(compared.get().before(), after.get(), context.vocabulary());
        comparison = Optional.of(now);
        view.show(
                now.both(),
                context.vocabulary(),
                NetLayout.edited(
                        now.both(),
                        context.vocabulary(),
                        NetFonts::width,
                        NetDetail.READER,
                        anew
                                ? OptionalDouble.empty()
                                : OptionalDouble.of(view.drawing().scale())));
        view.setChanges(now.changes());
        if (anew || !now.isNominal()) {
            view.setMode(now.isNominal() ? NetMode.NOMINAL : NetMode.ALL);
        }
        if (anew) {
            view.fit();
        }
        rows.clear();
        rows.addAll(solution ? now.differences().stream().map(SolutionWords::of).toList() : now.differences());
        int count = now.differences().size();
        String differs = count == 0
                ? "is equal to"
                : (count == 1 ? "has one difference" : "has " + count + " differences") + " from";
        title.setText("\"" + after.get().title() + "\" " + differs + " "
                + compared.get().name());
    }

    /** What differs, in words. */
    List<Difference> differences() {
        return Collections.list(rows.elements());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE);
        title.setFont(Fonts.text());
        list.setFont(Fonts.text());
    }
}
