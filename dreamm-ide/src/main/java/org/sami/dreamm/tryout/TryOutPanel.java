package org.sami.dreamm.tryout;

import java.awt.BorderLayout;
import java.awt.Insets;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.spn.stepping.Stepper;
import org.sami.ui.EventThread;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.PlainTextUI;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/**
 * Tries the open plan: what can happen now, what one of it needs, and what was done. The tokens are on the net. On the event thread.
 */
public final class TryOutPanel extends FoldingPanel {
    private static final int ALL_WORDS = 990;
    private static final int SHORT_WORDS = 850;
    private static final int FEWEST_WORDS = 810;
    private static final int TWO_ROWS = 520;
    private static final String LIST_LEFT = "[64%, grow, fill][36%, grow, fill]";
    private static final String WIDE_HALVES = "[44%, grow, fill][260:56%, grow, fill]";
    private static final String SMALL_HALVES = "[36%, grow, fill][260:64%, grow, fill]";
    private static final String LIST_ALONE = "[grow, fill]";
    private static final String HALVES = "insets 0, gap 1, fill";
    private static final String STACKED = "[44%, grow, fill][56%, grow, fill]";
    private static final int TAB = 30;
    private static final int HIGH_TAB = 40; // with buttons behind it
    private static final String BEHIND_TABS = "JTabbedPane.trailingComponent";

    private final transient DreammContext context;
    private final transient TryOut tryOut;
    private final transient TryOutCommands commands;
    private final RowTable<PossibleStep> possibleSteps;
    private final Column editorPlace = new Column();
    private final transient MigLayout bars =
            new MigLayout("insets 4 8 4 8, gap 6, hidemode 3", "[][][][][][]12[grow, fill]", "[]");
    private final transient MigLayout halves = new MigLayout(HALVES, WIDE_HALVES, "[grow, fill]");
    private final JPanel now = new JPanel(halves);
    private final JPanel bar = new JPanel(bars);
    private final JPanel one = new JPanel(new BorderLayout());
    private final JPanel buttons =
            new JPanel(new MigLayout("novisualpadding, insets 4, gap 8, hidemode 3", "push[][]", "[]"));
    private final JPanel behindTabs = new JPanel(new MigLayout("novisualpadding, insets 0, gap 8", "push[]", "[]"));
    private final JPanel foot =
            new JPanel(new MigLayout("insets 2 12 4 12, gap 16, hidemode 3", "[grow, fill][]", "[]"));
    private final transient MigLayout columns = new MigLayout("insets 0, gap 1, fill", LIST_LEFT, "[grow, fill]");
    private final JPanel parts = new JPanel(columns);
    private final JButton happen = new JButton("Let it happen");
    private final JButton reject = new JButton("None of them");
    private final JLabel message = new JLabel();
    private final JLabel where = new JLabel();
    private final transient PlayerSettings settings;
    private final JTabbedPane tabs = new JTabbedPane();
    private final transient CommandButton run;
    private final transient List<CommandButton> worded = new ArrayList<>();
    private final transient Fold narrow = foldBelowWidth(ALL_WORDS, this::hideWords);
    private transient Optional<PossibleStepEditor> editor = Optional.empty();
    private int shownSteps = -1;

    /** The panel of a window. */
    public TryOutPanel(
            DreammContext context, TryOut tryOut, TryOutCommands commands, StartMarkingSetup setup, SavedCases cases) {
        super(new BorderLayout());
        this.context = context;
        this.tryOut = tryOut;
        this.commands = commands;
        setName("try-out-panel");
        possibleSteps = new RowTable<>(
                "try-possible-steps",
                "Nothing can happen now. Start (F5) begins the open plan with robots that are not real; what can happen then stands here.",
                PossibleStep::key,
                List.of(
                        RowColumn.<PossibleStep>words("Who", 84, PossibleStep::who)
                                .colored(row -> SemanticColor.MUTED),
                        RowColumn.words("What can happen now", 0, PossibleStep::what)));
        settings = new PlayerSettings(tryOut);
        run = new CommandButton(context.commands().get("try-run"));
        tabs.setName("try-tabs");
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        tabs.putClientProperty("JTabbedPane.tabHeight", TAB);
        tabs.putClientProperty("JTabbedPane.minimumTabWidth", 40); // all four side by side
        tabs.putClientProperty("JTabbedPane.tabInsets", new Insets(0, 8, 0, 8));
        tab("Steps", new StepsView(tryOut));
        tab("State", new StateView(context, tryOut));
        tab("Marking", new StartMarkingView(context, tryOut, setup));
        tab("Cases", new SavedCasesView(context, tryOut, cases));
        add(toolbar(), BorderLayout.NORTH);
        add(middle());
        add(foot(), BorderLayout.SOUTH);
        bind();
        tryOut.addListener(this::refresh);
        style();
        refresh();
    }

    private void tab(String title, JPanel view) {
        view.setName("try-tab-" + title.toLowerCase(Locale.ROOT));
        tabs.addTab(PlainTextUI.of(title), view);
    }

    private JPanel toolbar() {
        bar.setOpaque(false);
        for (String id : List.of("try-start", "try-step")) {
            CommandButton button = new CommandButton(context.commands().get(id));
            worded.add(button);
            bar.add(button, "hmin 32");
        }
        worded.add(run);
        bar.add(run, "hmin 32");
        for (String id : List.of("try-back", "try-restart", "try-stop")) {
            bar.add(CommandButton.iconOnly(context.commands().get(id)), "hmin 32");
        }
        bar.add(settings.row());
        return bar;
    }

    /** In a narrow panel buttons show their icons alone; where there is less room still, the settings are a tab of their own. */
    @Override
    public void doLayout() {
        boolean small = getWidth() < Look.px(FEWEST_WORDS);
        boolean brief = getWidth() < Look.px(SHORT_WORDS);
        if (!small) {
            settings.inRow(brief);
        }
        arrange(small);
        placeMessage(small);
        halve();
        super.doLayout();
    }

    private void hideWords(boolean hidden) {
        worded.forEach(button -> button.setHideActionText(hidden));
        showRun();
    }

    /** The button says what it does next, in a narrow panel by its icon alone. */
    private void showRun() {
        run.setText(narrow.isFolded() ? "" : commands.isRunning() ? "Pause" : "Run");
        run.setIcon(Icons.normal(commands.isRunning() ? "pause" : "run-on"));
    }

    /** The list of possible steps is next to the tabs, or the first of them where both would have no room. */
    private void arrange(boolean small) {
        boolean isTab = tabs.indexOfComponent(now) >= 0;
        if (small && !isTab) {
            parts.remove(now);
            columns.setColumnConstraints("[grow, fill]");
            tabs.insertTab("Now", null, now, "What can happen now", 0);
            settings.inColumn();
            tabs.addTab("Settings", settings.column());
            tabs.setSelectedIndex(0);
            parts.revalidate();
        } else if (!small && isTab) {
            tabs.remove(now);
            tabs.remove(settings.column());
            columns.setColumnConstraints(LIST_LEFT);
            parts.add(now, "wmin 0, hmin 0", 0);
            parts.revalidate();
        }
        placeButtons(small && !isTight());
    }

    /** What lets it happen stands below what is filled in, or behind the tabs where there is more width than height. */
    private void placeButtons(boolean behind) {
        JPanel place = behind ? behindTabs : one;
        if (buttons.getParent() != place) {
            place.add(buttons, behind ? "wmin 0" : BorderLayout.SOUTH);
            tabs.putClientProperty("JTabbedPane.tabHeight", behind ? HIGH_TAB : TAB);
            tabs.putClientProperty(BEHIND_TABS, behind ? behindTabs : null);
        }
    }

    private boolean isTight() {
        return getWidth() < Look.px(TWO_ROWS);
    }

    /** The message stands at the foot, or behind the buttons where there is little height. */
    private void placeMessage(boolean small) {
        boolean behind = small && !isTight();
        JPanel place = behind ? bar : foot;
        settings.row().setVisible(!small);
        if (message.getParent() != place) {
            place.add(message, behind ? "w 0, wmin 0, growx, pushx" : "wmin 0, h 20!", behind ? -1 : 0);
        }
        foot.setVisible(!behind);
        where.setVisible(!isTight());
    }

    /** Where both have little room, the list has all of it until there is something to fill in. */
    private void halve() {
        boolean small = tabs.indexOfComponent(now) >= 0;
        boolean alone = small && editor.isEmpty();
        if (alone) {
            now.remove(one);
        } else if (one.getParent() == null) {
            now.add(one, "wmin 0, hmin 0");
        }
        boolean stacked = isTight() && !alone;
        halves.setLayoutConstraints(stacked ? HALVES + ", wrap 1" : HALVES);
        halves.setRowConstraints(stacked ? STACKED : "[grow, fill]");
        halves.setColumnConstraints(alone || stacked ? LIST_ALONE : small ? SMALL_HALVES : WIDE_HALVES);
        now.revalidate();
    }

    private JPanel middle() {
        editorPlace.setOpaque(false);
        happen.setName("try-happen");
        happen.setToolTipText("Lets the selected thing happen (Enter in the list)");
        happen.addActionListener(e -> happen(false));
        reject.setName("try-reject");
        reject.addActionListener(e -> happen(true));
        one.setOpaque(false);
        JScrollPane scroll = editorPlace.inPane();
        buttons.setOpaque(false);
        buttons.add(reject, "hmin 32");
        buttons.add(happen, "hmin 32");
        one.add(scroll);
        one.add(buttons, BorderLayout.SOUTH);
        now.setOpaque(false);
        now.add(possibleSteps, "wmin 0, hmin 0");
        now.add(one, "wmin 0, hmin 0");
        parts.setOpaque(false);
        parts.add(now, "wmin 0, hmin 0");
        parts.add(tabs, "wmin 0, hmin 0");
        return parts;
    }

    private JPanel foot() {
        foot.setOpaque(false);
        behindTabs.setOpaque(false);
        message.setName("try-message");
        foot.add(message, "wmin 0, h 20!");
        where.setName("try-where");
        foot.add(where, "wmin 0");
        return foot;
    }

    private void bind() {
        possibleSteps.addSelectionListener(() -> showEditor(true));
        possibleSteps
                .table()
                .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke("ENTER"), "try-happen");
        possibleSteps.table().getActionMap().put("try-happen", new AbstractAction() {
            @Override
            public void actionPerformed(java.awt.event.ActionEvent e) {
                happen(false);
            }
        });
    }

    private void happen(boolean none) {
        editor.ifPresent(one -> {
            Optional<String> refused = none ? one.reject() : one.happen();
            refused.ifPresent(why -> message.setText("▲ " + why));
        });
    }

    private void refresh() {
        Optional<Stepper> stepper = tryOut.stepper();
        List<PossibleStep> possible =
                stepper.filter(s -> !tryOut.isOver()).map(PossibleStep::of).orElse(List.of());
        possibleSteps.show(possible);
        if (possibleSteps.selected().isEmpty() && !possible.isEmpty()) {
            possibleSteps.selectKeys(Set.of(possible.get(0).key()));
        }
        showEditor(tryOut.steps() != shownSteps);
        shownSteps = tryOut.steps();
        message.setText((tryOut.isOutdated() ? "▲ " : "") + tryOut.message());
        message.setToolTipText(tryOut.message().isEmpty() ? null : tryOut.message());
        LookColors.foreground(message, tryOut.isOutdated() ? SemanticColor.WARNING : SemanticColor.MUTED);
        where.setText(stepper.map(this::words).orElse(""));
        settings.refresh();
        showRun();
    }

    private String words(Stepper stepper) {
        String over = stepper.outcome()
                .map(outcome -> " · over: " + outcome.name().toLowerCase(Locale.ROOT))
                .orElse("");
        return tryOut.plan().orElse("") + " · step " + tryOut.steps() + " · " + SessionClock.text(stepper.nowMillis())
                + over;
    }

    /** Shows what the selected step needs; what the author is filling in stays until another is selected or a step was taken. */
    private void showEditor(boolean anew) {
        Optional<PossibleStep> selected =
                possibleSteps.selected().filter(row -> tryOut.stepper().isPresent());
        boolean same = editor.map(PossibleStepEditor::possibleStep).equals(selected);
        if (same && !anew && editor.filter(PossibleStepEditor::isTouched).isPresent()) {
            return;
        }
        if (!same || anew) {
            editor = selected.map(row -> new PossibleStepEditor(
                    context, tryOut, row, tryOut.stepper().orElseThrow()));
            editorPlace.removeAll();
            editor.ifPresent(shown -> editorPlace.add(shown.component(), BorderLayout.NORTH));
            editorPlace.revalidate();
            editorPlace.repaint();
            EventThread.later(() -> editorPlace.scrollRectToVisible(new Rectangle(0, 0, 1, 1)));
        }
        halve();
        happen.setEnabled(editor.isPresent());
        reject.setVisible(editor.filter(PossibleStepEditor::canReject).isPresent());
    }

    /** Shows a tab by its title. */
    void showTab(String title) {
        tabs.setSelectedIndex(tabs.indexOfTab(title));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (tabs != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE);
        message.setFont(Fonts.text());
        where.setFont(Fonts.text());
        LookColors.foreground(where, SemanticColor.MUTED);
    }

    /** As high as the view on it where what it holds is lower. */
    private static final class Column extends ScrolledPanel {
        Column() {
            super(new BorderLayout());
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return getParent() != null && getParent().getHeight() > getPreferredSize().height;
        }
    }
}
