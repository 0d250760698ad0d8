package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.text.BadLocationException;
import javax.swing.text.Document;
import javax.swing.text.PlainDocument;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.operator.mission.PlanTree;
import org.sami.palette.SemanticColor;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.command.OnePress;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.value.WrappedText;

/** The plans of the session's project in its mission tree, one click from a mission; they are searched by what they are called and what they do. */
public final class PlansPanel extends JPanel {
    private static final int LEAST_ROWS = 3;
    private static final int ROOM_FOR_ABOUT = 236;
    private static final int LOW = 170;
    private static final String IN_ROW = "novisualpadding, hidemode 3, insets 8 8 4 8, gap 4 4, fillx";
    private static final int ROUND_BUTTONS = 20; // insets above and below them, and gaps between three in a column
    private static final String WITH_VALUES = "With values…";

    private final OperatorContext context;
    private final MissionStarter starter;
    private final Document searched = new PlainDocument();
    private final PlanSearchField search = new PlanSearchField("plans-search", searched, this::toFound);
    private final PlanSearchField searchInRow = new PlanSearchField("plans-search-beside", searched, this::toFound);
    private final CommandRow above = new CommandRow();
    private final MigLayout rowLayout = new MigLayout(IN_ROW, "[grow,fill]", "[]");
    private final JPanel beside = new JPanel(rowLayout);
    private final CommandButton startInRow;
    private final CommandButton startWithInRow;
    private final RowTable<PlanTree.Line> table;
    private final OnePress begins = new OnePress();
    private final DisabledNote disabled = new DisabledNote("plans-disabled");
    private final ReadyNote ready;
    private final WrappedText about = new WrappedText("");
    private final Command start;
    private Optional<Project> project = Optional.empty();
    private Runnable shower = () -> {};

    PlansPanel(OperatorContext context, MissionStarter starter) {
        super(new BorderLayout());
        this.context = context;
        this.starter = starter;
        ready = new ReadyNote(context);
        setName("plans");
        table = new RowTable<>(
                "plans-table",
                "The project has no plan. Open another one, or draw one in the plan editor.",
                PlanTree.Line::number,
                List.of(
                        RowColumn.<PlanTree.Line>words("Plan", 270, PlanTree.Line::title)
                                .withIcon(line -> Optional.of(PlanIcon.of(line)))
                                .colored(line -> line.plan().isEmpty() ? SemanticColor.MUTED : SemanticColor.TEXT),
                        RowColumn.<PlanTree.Line>words("What it does", 0, PlansPanel::about)
                                .asSpare()));
        table.showWholeRows(LEAST_ROWS);
        table.showOneLine();
        start = context.commands()
                .add(new Command("mission-start", "Start mission", this::startSelected)
                        .withKey("ctrl ENTER")
                        .withIcon("play")
                        .unless(this::whyNotStart));
        Command startWith = context.commands()
                .add(new Command("mission-start-with", "Start mission with values…", this::startWithValues)
                        .withKey("ctrl shift N")
                        .withIcon("variables")
                        .unless(this::whyNotStart));
        table.addSelectionListener(() -> {
            start.refresh();
            startWith.refresh();
            disabled.show(chosen());
            tellAbout();
            EventThread.later(
                    table::scrollToSelection); // once the words below, which may take its row's place, are laid out
        });
        table.table().getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke("ENTER"), "start");
        table.table().getActionMap().put("start", start);
        context.commands()
                .add(new Command(
                                "plans-find",
                                "Search plans",
                                () -> (above.isVisible() ? search : searchInRow).requestFocusInWindow())
                        .withKey("ctrl F")
                        .withIcon("search"));
        PlanSearchField.onChange(searched, this::find);
        above.left(search).right(CommandButton.primary(start, "play")).right(new CommandButton(startWith));
        LookColors.border(above, () -> BorderFactory.createMatteBorder(0, 0, 1, 0, SemanticColor.BORDER.get()));
        beside.add(searchInRow, "growx, wmin 0");
        startInRow = named(CommandButton.primary(start, "play"));
        startWithInRow = named(new CommandButton(startWith));
        startWithInRow.setText(WITH_VALUES);
        startWithInRow.getAccessibleContext().setAccessibleName(startWith.title());
        beside.add(startInRow);
        beside.add(startWithInRow);
        add(above, BorderLayout.NORTH);
        add(beside, BorderLayout.EAST);
        arrange();
        add(table);
        JPanel notes = new JPanel(new BorderLayout());
        notes.setOpaque(false);
        about.setName("plan-about");
        LookColors.border(about, () -> {
            int above = Look.px(Spacing.NORMAL);
            int beside = Look.px(Spacing.INSET);
            return BorderFactory.createEmptyBorder(above, beside, above, beside);
        });
        notes.add(about, BorderLayout.NORTH);
        notes.add(disabled);
        notes.add(ready, BorderLayout.SOUTH);
        add(notes, BorderLayout.SOUTH);
        reload();
    }

    private static CommandButton named(CommandButton button) {
        button.setName(button.getName() + "-beside");
        return button;
    }

    /**
     * Where buttons above the table would leave it too few rows, they are next to it: in a column below the search; without it,
     * and then in a row, where the panel is lower still. In a row the second shows its words where they leave the table half of the width.
     */
    @Override
    public void doLayout() {
        arrange();
        super.doLayout();
    }

    /** What the selected plan does, in full: its row has one line. */
    private void tellAbout() {
        String words = table.selected().map(PlansPanel::about).orElse("");
        if (!about.getText().equals(words)) {
            about.setText(words);
        }
        about.setVisible(!words.isEmpty() && getHeight() >= Look.px(ROOM_FOR_ABOUT));
    }

    private void arrange() {
        tellAbout();
        boolean low = getHeight() < Look.px(LOW);
        above.setVisible(!low);
        beside.setVisible(low);
        ready.hasRoom(!low);
        int buttons = height(startInRow) + height(startWithInRow) + Look.px(ROUND_BUTTONS);
        boolean inColumn = buttons <= getHeight();
        searchInRow.setVisible(buttons + height(searchInRow) <= getHeight());
        String constraints = inColumn ? IN_ROW + ", wrap 1" : IN_ROW;
        if (!constraints.equals(rowLayout.getLayoutConstraints())) {
            rowLayout.setLayoutConstraints(constraints);
            beside.invalidate(); // its size may stay
        }
        String words = inColumn || 2 * rowOfWords() <= getWidth() ? WITH_VALUES : "";
        if (!words.equals(startWithInRow.getText())) {
            startWithInRow.setText(words);
        }
    }

    /** How wide a row of both buttons with all of their words is. */
    private int rowOfWords() {
        return startInRow.getPreferredSize().width
                + startWithInRow.getFontMetrics(startWithInRow.getFont()).stringWidth(WITH_VALUES)
                + 2 * Look.px(Spacing.HIT_TARGET_FIELD); // icon, margins, insets and gaps
    }

    private static int height(JComponent part) {
        return part.getPreferredSize().height;
    }

    private static String about(PlanTree.Line line) {
        return line.plan()
                .map(plan -> plan.description().isEmpty() ? plan.id() : plan.description())
                .orElse("");
    }

    private Optional<Plan> chosen() {
        return table.selected().flatMap(PlanTree.Line::plan);
    }

    private Optional<String> whyNotStart() {
        return chosen().isPresent()
                ? Optional.empty()
                : Optional.of(table.selected()
                        .map(folder -> "select a plan in " + folder.title() + " first")
                        .orElse("select a plan first"));
    }

    /** Says which boats are not ready; to be called a few times a second. */
    void refresh() {
        ready.refresh(chosen(), project);
    }

    /** Shows the plans of the newest project, as one was loaded or the session began. */
    public void reload() {
        context.shown().ask(EngineView::project).thenAccept(this::show);
    }

    private void show(Project loaded) {
        project = Optional.of(loaded);
        disabled.reserve(loaded.plans().stream()
                .anyMatch(plan -> !DisabledParts.warning(plan).isEmpty()));
        String name = loaded.name().isEmpty() ? loaded.id() : loaded.name();
        search.setToolTipText("Search the plans of " + name);
        searchInRow.setToolTipText(search.getToolTipText());
        find();
    }

    /** Shows what is searched for; a plan is selected as long as any is found. */
    private void find() {
        List<PlanTree.Line> found =
                project.map(loaded -> PlanTree.of(loaded, searched())).orElse(List.of());
        table.show(found);
        if (chosen().isEmpty()) {
            List<PlanTree.Line> plans =
                    found.stream().filter(line -> line.plan().isPresent()).toList();
            plans.stream()
                    .filter(line -> line.plan().orElseThrow().id().equals(SessionOpener.OFFERED_PLAN))
                    .findFirst()
                    .or(() -> plans.stream().findFirst())
                    .ifPresent(line -> table.offer(Set.of(line.number())));
        }
        context.commands().refresh();
    }

    private String searched() {
        try {
            return searched.getText(0, searched.getLength());
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private void toFound() {
        table.table().requestFocusInWindow();
    }

    /** Where the focus is to be when the window opens. */
    JComponent first() {
        return table.table();
    }

    /** Starts what is seen to be selected; where it is out of sight it is shown first, and the next press starts it. */
    private void startSelected() {
        chosen().ifPresent(plan -> {
            if (table.isSelectionSeen()) {
                if (begins.isOwn()) {
                    starter.start(plan);
                }
            } else {
                show(plan);
            }
        });
    }

    private void show(Plan plan) {
        shower.run();
        table.scrollToSelection();
        first().requestFocusInWindow();
        context.notices()
                .refused("Nothing has begun: " + plan.title() + " was out of sight. " + start.keyText()
                        + " again starts it");
    }

    /** Is run to bring these plans to the front, where what is to be started is out of sight. */
    void onNeedToShow(Runnable next) {
        shower = next;
    }

    private void startWithValues() {
        chosen().ifPresent(plan -> project.ifPresent(loaded -> starter.startWithValues(this, loaded, plan)));
    }
}
