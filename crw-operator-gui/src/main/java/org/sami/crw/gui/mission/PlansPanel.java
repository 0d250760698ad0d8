package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** The plans of the session's project, one click from a mission. */
public final class PlansPanel extends JPanel {
    private static final int LEAST_ROWS = 3;
    private static final int LOW = 170;
    private static final String BESIDE = "novisualpadding, hidemode 3, insets 8 8 4 8, gap 4 4, fillx";
    private static final int ROUND_BUTTONS = 20; // insets above and below them, and gaps between three in a column
    private static final String WITH_VALUES = "With values…";

    private final OperatorContext context;
    private final MissionStarter starter;
    private final JLabel title = new StrongLabel("");
    private final JLabel titleBeside = new StrongLabel("");
    private final CommandRow above = new CommandRow();
    private final MigLayout besideLayout = new MigLayout(BESIDE, "[grow,fill]", "[]");
    private final JPanel beside = new JPanel(besideLayout);
    private final CommandButton startBeside;
    private final CommandButton startWithBeside;
    private final RowTable<Plan> table;
    private final Command start;
    private Optional<Project> project = Optional.empty();
    private Runnable shower = () -> {};

    PlansPanel(OperatorContext context, MissionStarter starter) {
        super(new BorderLayout());
        this.context = context;
        this.starter = starter;
        setName("plans");
        table = new RowTable<>(
                "plans-table",
                "The project has no plan. Open another one, or draw one in the plan editor.",
                Plan::id,
                List.of(
                        RowColumn.words("Plan", 190, Plan::title),
                        RowColumn.<Plan>words("What it does", 0, PlansPanel::about)
                                .asSpare()));
        table.showWholeRows(LEAST_ROWS);
        start = context.commands()
                .add(new Command("mission-start", "Start mission", this::startSelected)
                        .withKey("ctrl ENTER")
                        .withIcon("play")
                        .unless(() ->
                                table.selected().isPresent() ? Optional.empty() : Optional.of("select a plan first")));
        Command startWith = context.commands()
                .add(new Command("mission-start-with", "Start mission with values…", this::startWithValues)
                        .withKey("ctrl shift N")
                        .withIcon("variables")
                        .unless(() ->
                                table.selected().isPresent() ? Optional.empty() : Optional.of("select a plan first")));
        table.addSelectionListener(() -> {
            start.refresh();
            startWith.refresh();
        });
        table.table().getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke("ENTER"), "start");
        table.table().getActionMap().put("start", start);
        above.left(title).right(CommandButton.primary(start, "play")).right(new CommandButton(startWith));
        LookColors.border(above, () -> BorderFactory.createMatteBorder(0, 0, 1, 0, SemanticColor.BORDER.get()));
        beside.add(titleBeside, "wmin 0");
        startBeside = named(CommandButton.primary(start, "play"));
        startWithBeside = named(new CommandButton(startWith));
        startWithBeside.setText(WITH_VALUES);
        startWithBeside.getAccessibleContext().setAccessibleName(startWith.title());
        beside.add(startBeside);
        beside.add(startWithBeside);
        add(above, BorderLayout.NORTH);
        add(beside, BorderLayout.EAST);
        arrange();
        add(table);
        reload();
    }

    private static CommandButton named(CommandButton button) {
        button.setName(button.getName() + "-beside");
        return button;
    }

    /**
     * Where buttons above the table would leave it too few rows, they stand beside it: in a column below the project's name; without the name,
     * and then in a row, where the panel is lower still. In a row the second shows its words where they leave the table half of the width.
     */
    @Override
    public void doLayout() {
        arrange();
        super.doLayout();
    }

    private void arrange() {
        boolean low = getHeight() < Look.px(LOW);
        above.setVisible(!low);
        beside.setVisible(low);
        int buttons = height(startBeside) + height(startWithBeside) + Look.px(ROUND_BUTTONS);
        boolean inColumn = buttons <= getHeight();
        titleBeside.setVisible(buttons + height(titleBeside) <= getHeight());
        String constraints = inColumn ? BESIDE + ", wrap 1" : BESIDE;
        if (!constraints.equals(besideLayout.getLayoutConstraints())) {
            besideLayout.setLayoutConstraints(constraints);
            beside.invalidate(); // its size may stay
        }
        String words = inColumn || 2 * rowOfWords() <= getWidth() ? WITH_VALUES : "";
        if (!words.equals(startWithBeside.getText())) {
            startWithBeside.setText(words);
        }
    }

    /** How wide a row of both buttons with all of their words is. */
    private int rowOfWords() {
        return startBeside.getPreferredSize().width
                + startWithBeside.getFontMetrics(startWithBeside.getFont()).stringWidth(WITH_VALUES)
                + 2 * Look.px(Spacing.HIT_TARGET_FIELD); // icon, margins, insets and gaps
    }

    private static int height(JComponent part) {
        return part.getPreferredSize().height;
    }

    private static String about(Plan plan) {
        return plan.description().isEmpty() ? plan.id() : plan.description();
    }

    /** Shows the plans of the newest project, as one was loaded or the session began. */
    public void reload() {
        context.shown().ask(EngineView::project).thenAccept(this::show);
    }

    private void show(Project loaded) {
        project = Optional.of(loaded);
        String name = loaded.name().isEmpty() ? loaded.id() : loaded.name();
        title.setText(name);
        titleBeside.setText(name);
        titleBeside.setToolTipText(name);
        table.show(loaded.plans());
        if (table.selected().isEmpty() && !loaded.plans().isEmpty()) {
            String offered = loaded.plan(SessionOpener.OFFERED_PLAN).isPresent()
                    ? SessionOpener.OFFERED_PLAN
                    : loaded.plans().get(0).id();
            table.offer(Set.of(offered));
            context.commands().refresh();
        }
    }

    /** Where the focus is to be when the window opens. */
    JComponent first() {
        return table.table();
    }

    /** Starts what is seen to be selected; where it is out of sight it is shown first, and the next press starts it. */
    private void startSelected() {
        table.selected().ifPresent(plan -> {
            if (table.isSelectionSeen()) {
                starter.start(plan);
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
        table.selected().ifPresent(plan -> project.ifPresent(loaded -> starter.startWithValues(this, loaded, plan)));
    }
}
