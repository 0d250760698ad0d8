package org.sami.crw.gui.boat;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.PlainTextUI;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.WidthTrackingPanel;

/**
 * The selected boat: why it moves or not, its command queue, what is to be so before it is launched, driving by hand, its settings, and what
 * else can be done with it.
 */
public final class SelectedBoatPanel extends FoldingPanel implements AutoCloseable {
    private static final String HEAD = "insets 8 12 8 12, fillx, hidemode 3, wrap 1";
    private static final String LOW_HEAD = "insets 4 12 4 12, fillx, hidemode 3";
    private static final String QUEUE = "hmin 60"; // a whole row below the titles of the columns
    private static final int LOW = 240;
    private static final int TIGHT = 178; // lower, the buttons would leave the commands no row

    private final OperatorContext context;
    private final JLabel name = new JLabel();
    private final JLabel why = new JLabel();
    private final JLabel facts = new JLabel();
    private final transient BoatControl control;
    private final BoatQueue queue;
    private final SettingsForm settings;
    private final LaunchPanel launch;
    private final ByHandPanel byHand;
    private final MigLayout headLayout = new MigLayout(HEAD, "[grow]", "[]4[]4[]");
    private final JPanel head = new JPanel(headLayout);
    private final MigLayout commandsLayout =
            new MigLayout("insets 0, gap 0, fill, wrap 1", "[grow,fill]", "[grow,fill][]");
    private final JPanel commands = new JPanel(commandsLayout);
    private final transient Fold low = foldBelowHeight(LOW, this::foldHead);

    /** The panel of whichever boat is selected first. */
    public SelectedBoatPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        control = new BoatControl(context);
        queue = new BoatQueue(context);
        settings = new SettingsForm(context);
        launch = new LaunchPanel(context);
        byHand = new ByHandPanel(control.teleoperation(), context::say);
        name.setName("boat-name");
        why.setName("boat-why");
        facts.setName("boat-facts");
        head.add(name, "shrink 0");
        head.add(why, "wmin 0");
        head.add(facts, "wmin 0");
        JTabbedPane tabs = new JTabbedPane();
        tabs.setName("boat-tabs");
        tabs.addTab("Commands", WidthTrackingPanel.fromLeastHeight(commands));
        tabs.addTab(PlainTextUI.of(context.say("Before launch")), WidthTrackingPanel.fromLeastHeight(launch));
        if (control.teleoperation().isOffered()) {
            tabs.addTab("By hand", WidthTrackingPanel.fromLeastHeight(byHand));
        }
        tabs.addTab("Settings", scrolled(settings));
        CommandRow buttons = new CommandRow();
        control.commands().forEach(command -> buttons.left(new CommandButton(command)));
        buttons.left(new CommandButton(queue.cancelCommand()));
        add(head, BorderLayout.NORTH);
        add(tabs);
        commands.add(queue.table(), QUEUE);
        commands.add(buttons);
        foldBelowHeight(TIGHT, this::scrollWholeTab);
        context.boats().addListener(this::refresh);
        refresh();
    }

    /** Gives a boat that is driven by hand, or whose motor is tried, back to the missions: no window goes on driving it. */
    @Override
    public void close() {
        control.close();
        launch.close();
    }

    /** A low panel has one line above its tabs, and says the facts in a tooltip. */
    private void foldHead(boolean toOneLine) {
        headLayout.setLayoutConstraints(toOneLine ? LOW_HEAD : HEAD);
        headLayout.setColumnConstraints(toOneLine ? "[]16[grow]" : "[grow]");
        facts.setVisible(!toOneLine && !facts.getText().isEmpty());
        head.revalidate();
        byHand.setLow(toOneLine);
    }

    /** Of its commands a panel shows one at least: where it is lower still, the whole tab is scrolled, and nothing within it. */
    private void scrollWholeTab(boolean tight) {
        queue.table().showAllRows(tight);
        commandsLayout.setComponentConstraints(queue.table(), tight ? "" : QUEUE);
        commands.revalidate();
    }

    private static JScrollPane scrolled(JPanel form) {
        JScrollPane pane = new JScrollPane(form);
        pane.setBorder(BorderFactory.createEmptyBorder());
        pane.getVerticalScrollBar().setUnitIncrement(Spacing.WIDE);
        return pane;
    }

    /** Shows how the boat is now; to be called a few times a second. */
    public void refresh() {
        Optional<BoatSnapshot> boat =
                context.boats().first().flatMap(context.models().fleet()::boat);
        Optional<String> id = boat.map(BoatSnapshot::boat);
        queue.show(id);
        settings.show(id, boat.flatMap(BoatSnapshot::settings));
        launch.show(boat);
        byHand.refresh();
        name.setFont(Fonts.heading());
        if (boat.isEmpty()) {
            name.setText(context.say("No boat is selected"));
            name.setIcon(null);
            why.setText("Select one in the list or on the map.");
            why.setToolTipText(why.getText());
            LookColors.foreground(why, SemanticColor.MUTED);
            facts.setText("");
            facts.setVisible(false);
            return;
        }
        BoatSnapshot now = boat.get();
        name.setText(now.boat());
        name.setIcon(BoatNameColumn.icon(context, now.boat()));
        why.setText(context.sayOf(now.boat(), BoatWords.state(now)));
        why.setToolTipText(why.getText());
        LookColors.foreground(why, BoatWords.color(BoatWords.trouble(now)));
        facts.setText(context.sayOf(now.boat(), facts(now)));
        facts.setVisible(!low.isFolded());
        facts.setToolTipText(facts.getText());
        name.setToolTipText(facts.getText());
        LookColors.foreground(facts, SemanticColor.MUTED);
    }

    private String facts(BoatSnapshot boat) {
        List<String> words = new ArrayList<>();
        words.add(
                switch (boat.commander()) {
                    case THIS_BASE -> "commanded from here";
                    case BY_HAND -> "driven by hand";
                    case SOMEBODY_ELSE -> "commanded by another base";
                    case UNKNOWN -> "commander not known";
                });
        boat.mode()
                .ifPresent(mode ->
                        words.add("mode " + mode.name().toLowerCase(Locale.ROOT).replace('_', ' ')));
        words.add("battery " + BoatWords.battery(boat));
        words.add("link " + BoatWords.link(boat, context.nowMillis()));
        boat.pose()
                .ifPresent(pose -> words.add(String.format(
                        Locale.ROOT,
                        "%.6f, %.6f",
                        pose.position().latDeg(),
                        pose.position().lonDeg())));
        return String.join("  ·  ", words);
    }
}
