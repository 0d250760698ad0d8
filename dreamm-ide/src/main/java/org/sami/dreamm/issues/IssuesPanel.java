package org.sami.dreamm.issues;

import java.awt.BorderLayout;
import java.awt.Insets;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.Fix;
import org.sami.spn.finding.Severity;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/**
 * The issues as a table (thesis 5.1): a click shows where, below it stands what to do and what the program can do, above it what is shown.
 * Deep checks begin and stop here.
 */
public final class IssuesPanel extends FoldingPanel {
    /** Below it the rows need the room; a row's tooltip says all as well. */
    private static final int LEAST_HEIGHT_OF_MESSAGE = 220;

    private static final int NARROW = 640;
    private static final int TWO_ROWS = 420;
    private static final String ONE_ROW = "[][][]16[][grow][]";
    private static final String ROWS = "[][][]16[grow]";
    private static final String FILTER = "cell 4 0, growx, wmin 80, wmax 320, hmin 32";
    private static final String FILTER_BELOW = "cell 0 1 4 1, growx, wmin 80, hmin 32";
    private static final String SEARCHED = "cell 0 1 6 1, growx, wmin 0";
    private static final String SEARCHED_BELOW = "cell 0 2 4 1, growx, wmin 0";
    private static final String SEARCH = "cell 5 0";
    private static final String SEARCH_BELOW = "cell 0 1 4 1";
    private static final String FIXES = "novisualpadding, insets 0, gap 8";
    private static final String FIXES_IN_COLUMN = FIXES + ", wrap 1";

    private final transient DreammContext context;
    private final transient IssueList issues;
    private final RowTable<Issue> table;
    private final Map<Severity, JToggleButton> severities = new EnumMap<>(Severity.class);
    private final JCheckBox onlyOpen = new JCheckBox("Open plan only");
    private final JTextField text = new JTextField(12);
    private final transient MigLayout bars =
            new MigLayout("novisualpadding, insets 4 8 4 8, gap 8, hidemode 3", ONE_ROW, "[]");
    private final JTextArea message = new JTextArea();
    private final transient MigLayout fixColumns = new MigLayout(FIXES, "[][][][]push[]", "[]");
    private final JPanel fixes = new JPanel(fixColumns);
    private final JScrollPane mending = mending();
    private final JLabel hidden = new JLabel();
    private final JButton showAll = new JButton("Show all");
    private final JPanel hiding = hiding();
    private final DeepChecksBar deep;

    /**
     * A view of issues.
     *
     * @param commands those that act on the list
     */
    public IssuesPanel(DreammContext context, IssueList issues, IssueCommands commands) {
        super(new BorderLayout());
        this.context = context;
        this.issues = issues;
        setName("issues-panel");
        table = new RowTable<>(
                "issues-table",
                "No issues. What keeps a plan from being run, or may not be meant so, appears here as you draw.",
                Issue::key,
                List.of(
                        RowColumn.<Issue>words(
                                        "Code", 180, issue -> issue.finding().code())
                                .colored(issue -> color(issue.finding().severity()))
                                .asLastSpare(),
                        RowColumn.<Issue>words(
                                        "Plan", 110, issue -> issue.finding().plan())
                                .colored(issue -> SemanticColor.MUTED)
                                .asSpare(),
                        RowColumn.<Issue>words(
                                        "What is wrong, and what to do",
                                        0,
                                        issue -> issue.finding().message())
                                .withIcon(IssuesPanel::icon),
                        RowColumn.<Issue>words("Fix", 160, IssuesPanel::offer)
                                .colored(issue -> SemanticColor.ACCENT)
                                .asSpare()));
        deep = new DeepChecksBar(commands);
        bindTable();
        JPanel head = new JPanel(new BorderLayout());
        head.setOpaque(false);
        head.add(top());
        head.add(hiding, BorderLayout.SOUTH);
        add(head, BorderLayout.NORTH);
        add(table);
        add(mending, BorderLayout.SOUTH);
        issues.addListener(this::refresh);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                showCurrent();
            }
        });
        foldBelowWidth(NARROW, deep::setNarrow);
        Fold tight = foldBelowWidth(TWO_ROWS, this::putInRows);
        foldWhere(() -> !tight.isFolded() && isLow(), this::putFixesToTheRight);
        commands.deep().addListener(this::refresh);
        style();
        refresh();
    }

    private static String offer(Issue issue) {
        return issue.fixes().stream()
                .findFirst()
                .map(Fix::label)
                .orElse(issue.witness().isPresent() ? "Play the run" : "");
    }

    private static SemanticColor color(Severity severity) {
        return switch (severity) {
            case ERROR -> SemanticColor.CRITICAL;
            case WARNING -> SemanticColor.WARNING;
            case NOTE -> SemanticColor.MUTED;
        };
    }

    static Icon icon(Severity severity) {
        String name = switch (severity) {
            case ERROR -> "stop";
            case WARNING -> "alarm";
            case NOTE -> "message";
        };
        return Icons.of(name, 16, color(severity));
    }

    private static Optional<Icon> icon(Issue issue) {
        return Optional.of(icon(issue.finding().severity()));
    }

    private void bindTable() {
        table.table().getAccessibleContext().setAccessibleName("Issues");
        table.addSelectionListener(() -> table.selected().ifPresent(issues::lookAt));
        table.table().getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(IssueCommands.SHOW, "issue-show");
        table.table().getActionMap().put("issue-show", context.commands().get("issue-show"));
    }

    private JPanel top() {
        JPanel bar = new JPanel(bars);
        bar.setOpaque(false);
        for (Severity severity : Severity.values()) {
            String word = severity.name().toLowerCase(Locale.ROOT);
            JToggleButton button = new JToggleButton();
            button.setName("issues-show-" + word);
            button.setMargin(new Insets(2, Spacing.NORMAL, 2, Spacing.NORMAL));
            button.setSelected(true);
            button.setToolTipText("Show " + word + "s, or hide them");
            button.addActionListener(e -> issues.setFilter(issues.filter().with(severity, button.isSelected())));
            severities.put(severity, button);
            bar.add(button, "hmin 32");
        }
        onlyOpen.setName("issues-only-open");
        onlyOpen.setOpaque(false);
        onlyOpen.setMnemonic('O');
        onlyOpen.setToolTipText("Show the issues of the plan that is open, or of all plans");
        onlyOpen.addActionListener(e -> issues.setOnlyOpenPlan(onlyOpen.isSelected()));
        bar.add(onlyOpen);
        text.setName("issues-filter");
        text.putClientProperty("JTextField.placeholderText", "Filter by code, plan or word");
        text.getAccessibleContext().setAccessibleName("Filter of the issues");
        text.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                issues.setFilter(issues.filter().containing(text.getText()));
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                insertUpdate(e);
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                // styles only
            }
        });
        bar.add(text, FILTER);
        bar.add(deep.status(), SEARCHED); // a line of its own: what it says is read whole
        bar.add(deep, SEARCH);
        return bar;
    }

    @Override
    public void doLayout() {
        showMending();
        super.doLayout();
    }

    private void putInRows(boolean several) {
        bars.setColumnConstraints(several ? ROWS : ONE_ROW);
        bars.setComponentConstraints(text, several ? FILTER_BELOW : FILTER);
        bars.setComponentConstraints(deep.status(), several ? SEARCHED_BELOW : SEARCHED);
        bars.setComponentConstraints(deep, several ? SEARCH_BELOW : SEARCH);
    }

    /** In a low panel the fixes of an issue are to the right of the table, which keeps its rows. */
    private void putFixesToTheRight(boolean right) {
        fixColumns.setLayoutConstraints(right ? FIXES_IN_COLUMN : FIXES);
        add(mending, right ? BorderLayout.EAST : BorderLayout.SOUTH);
    }

    private JScrollPane mending() {
        ScrolledPanel panel = new ScrolledPanel(
                new MigLayout("novisualpadding, insets 4 12 6 12, gap 4, wrap, hidemode 3", "[grow, fill]", "[][]"));
        message.setName("issue-message");
        message.setEditable(false);
        message.setFocusable(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        message.setOpaque(false);
        fixes.setName("issue-fixes");
        fixes.setOpaque(false);
        panel.add(message, "wmin 0");
        panel.add(fixes, "wmin 0");
        return panel.inPane();
    }

    /** Says how many issues the filter hides, and takes it away. */
    private JPanel hiding() {
        JPanel line = new JPanel(new MigLayout("novisualpadding, insets 0 8 4 8, gap 8", "[grow, fill][]", "[]"));
        line.setOpaque(false);
        hidden.setName("issues-hidden");
        showAll.setName("issues-show-all");
        showAll.setToolTipText("Show the issues of all kinds and plans");
        showAll.addActionListener(e -> {
            severities.values().forEach(button -> button.setSelected(true));
            onlyOpen.setSelected(false);
            text.setText("");
            issues.setOnlyOpenPlan(false);
            issues.setFilter(IssueFilter.ALL);
        });
        line.add(hidden, "wmin 0");
        line.add(showAll, "hmin 32");
        line.setVisible(false);
        return line;
    }

    private void showHidden() {
        int all = issues.all().size();
        int count = all - issues.shown().size();
        hidden.setText((count == all && all > 1 ? "All " + all : String.valueOf(count))
                + (count == 1 ? " issue is" : " issues are") + " hidden by the filter");
        hiding.setVisible(count > 0);
    }

    private void refresh() {
        table.show(issues.shown());
        showHidden();
        table.selectKeys(issues.current().map(issue -> Set.of(issue.key())).orElse(Set.of()));
        IssueCounts counts = issues.counts();
        label(Severity.ERROR, counts.errors());
        label(Severity.WARNING, counts.warnings());
        label(Severity.NOTE, counts.notes());
        showCurrent();
        deep.refresh();
        context.commands().refresh();
    }

    private void label(Severity severity, int count) {
        JToggleButton button = button(severity);
        button.setText(String.valueOf(count));
        String word = severity.name().toLowerCase(Locale.ROOT);
        button.getAccessibleContext().setAccessibleName(count + " " + word + "s");
    }

    private void showCurrent() {
        message.setText(issues.current().map(IssueWords::of).orElse(""));
        fixes.removeAll();
        issues.current().ifPresent(issue -> {
            for (int i = 0; i < issue.fixes().size(); i++) {
                fixes.add(button(issue.fixes().get(i), i), "hmin 32");
            }
            issue.witness()
                    .ifPresent(run ->
                            fixes.add(new CommandButton(context.commands().get("issue-play")), "hmin 32"));
        });
        showMending();
        fixes.revalidate();
    }

    private void showMending() {
        message.setVisible(issues.current().isPresent() && !isLow());
        fixes.setVisible(fixes.getComponentCount() > 0);
        mending.setVisible(message.isVisible() || fixes.isVisible());
    }

    private boolean isLow() {
        return getHeight() <= Look.px(LEAST_HEIGHT_OF_MESSAGE);
    }

    private JButton button(Fix fix, int index) {
        JButton button = new JButton(fix.label());
        button.setName("issue-fix-" + (index + 1));
        button.setToolTipText(index == 0 ? fix.label() + " (Alt+Enter)" : fix.label());
        button.setEnabled(context.profile().allows("issue-fix"));
        button.addActionListener(e -> context.apply(fix.edit()));
        return button;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (table != null) {
            style();
            refresh();
        }
    }

    private JToggleButton button(Severity severity) {
        return Objects.requireNonNull(severities.get(severity), severity::name);
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE);
        message.setFont(Fonts.text());
        LookColors.foreground(message, SemanticColor.TEXT);
        hidden.setFont(Fonts.text());
        LookColors.foreground(hidden, SemanticColor.WARNING);
        for (Severity severity : Severity.values()) {
            button(severity).setIcon(icon(severity));
        }
    }
}
