package org.sami.crw.gui.status;

import java.awt.Insets;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.boat.BoatWords;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.RobotIcons;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.AlarmCount;
import org.sami.crw.operator.boat.Age;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.FleetCount;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.window.NoticeLabel;

/** The strip at the top of the window: what there is, what waits, what is wrong, and the fleet stop. */
public final class StatusStrip extends FoldingPanel {
    private static final int WIDE_FROM = 1100;
    private static final int TIGHT = 720;
    private static final String LAYOUT = "insets 6 12 6 8, hidemode 3, gap ";
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss");

    private final transient MigLayout layout;
    private final OperatorContext context;
    private final FleetStopCommands fleetStop;
    private final JLabel missions = new JLabel();
    private final JLabel decisions = new JLabel();
    private final JLabel boats = new JLabel();
    private final JLabel links = new JLabel();
    private final JLabel clock = new JLabel();
    private final NoticeLabel notice;
    private final JButton alarms = new JButton();
    private final JButton unseen = new JButton();
    private final transient Supplier<Optional<String>> decisionUnseen;
    private final String keyOfDecisions;
    private final String keyOfAlarms;
    private boolean red;
    private final transient Fold narrow = foldBelowWidth(WIDE_FROM, this::narrow);
    private final CommandButton stop;
    private final JLabel sent = new JLabel();
    private final CommandButton release;
    private final CommandButton confirm;

    /**
     * The strip of a window.
     *
     * @param showAlarms brings the alarms to the front
     * @param showDecisions brings the decisions to the front
     * @param decisionUnseen what the most urgent decision asks, where one waits behind another panel
     */
    public StatusStrip(
            OperatorContext context,
            FleetStopCommands fleetStop,
            Command showAlarms,
            Command showDecisions,
            Supplier<Optional<String>> decisionUnseen) {
        super(new MigLayout(
                LAYOUT + 20,
                "[][][][][shrinkprio 250]8:push[grow 0, shrinkprio 300]push[shrinkprio 200][][shrink 0]",
                "[]"));
        layout = (MigLayout) getLayout();
        this.context = context;
        this.fleetStop = fleetStop;
        this.decisionUnseen = decisionUnseen;
        setName("status-strip");
        stop = new CommandButton(fleetStop.stop());
        release = new CommandButton(fleetStop.release());
        confirm = CommandButton.confirming(fleetStop.confirm());
        foldBelowWidth(TIGHT, release::setHideActionText); // its tooltip says it; the step that releases has its words
        alarms.setFocusable(false);
        alarms.setName("alarms-count");
        alarms.addActionListener(showAlarms);
        keyOfAlarms = showAlarms.keyText();
        unseen.setFocusable(false);
        unseen.setName("decision-unseen");
        unseen.addActionListener(showDecisions);
        keyOfDecisions = showDecisions.keyText();
        missions.setName("missions-count");
        decisions.setName("decisions-count");
        boats.setName("boats-count");
        links.setName("links-count");
        clock.setName("clock");
        List.of(missions, decisions, boats, links).forEach(label -> add(label, "wmin 32"));
        add(unseen, "h 40!, wmin 56, wmax 360, hidemode 2, shrinkprio 250"); // nothing that can be pressed moves as it
        // comes
        notice = new NoticeLabel(context.notices(), System::nanoTime);
        add(notice, "wmin 0, shrinkprio 300, gapright 8");
        add(clock, "wmin 0, shrinkprio 200");
        add(alarms, "h 40!");
        JPanel stops = new JPanel(new MigLayout("novisualpadding, insets 0, gap 0, hidemode 3", "[][][][]", "[]"));
        stops.setOpaque(false);
        sent.setName("fleet-stop-sent");
        stops.add(sent, "gapright 8");
        stops.add(release, "gapright 8"); // gaps that go with them: the stop stays where it is
        stops.add(confirm, "gapright 8");
        stops.add(stop, "h 44!");
        add(stops, "shrink 0"); // it is never cut
        fleetStop.onChange(this::refresh);
        style();
        refresh();
    }

    private void narrow(boolean narrower) {
        layout.setLayoutConstraints(LAYOUT + (narrower ? 8 : 20));
        refresh();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (stop != null) {
            style();
            refresh(); // colours are the theme's
        }
    }

    private void style() {
        LookColors.background(this, red ? SemanticColor.CRITICAL_FILL : SemanticColor.SURFACE);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(0, 0, 1, 0, SemanticColor.BORDER.get()));
        List.of(missions, decisions, boats, links).forEach(label -> label.setFont(Fonts.strong()));
        missions.setIcon(icon("net"));
        decisions.setIcon(icon("decision"));
        boats.setIcon(icon(RobotIcons.one(context.robots())));
        ink(missions, SemanticColor.TEXT);
        notice.setInk(red ? Optional.of(SemanticColor.ON_CRITICAL) : Optional.empty());
        ink(clock, SemanticColor.TEXT);
        sent.setFont(Fonts.strong());
        ink(sent, SemanticColor.CRITICAL);
        alarms.setFont(Fonts.strong());
        unseen.setFont(Fonts.strong());
        LookColors.foreground(unseen, SemanticColor.ON_WARNING);
        LookColors.background(unseen, SemanticColor.WARNING_FILL);
        SemanticColor onStop =
                red ? SemanticColor.CRITICAL_FILL : SemanticColor.ON_CRITICAL; // it stands out on a strip that is red
        LookColors.background(stop, red ? SemanticColor.ON_CRITICAL : SemanticColor.CRITICAL_FILL);
        LookColors.foreground(stop, onStop);
        stop.setIcon(Icons.of("stop", 20, onStop));
        stop.setFont(Fonts.heading());
    }

    private Icon icon(String name) {
        return Icons.of(name, 16, red ? SemanticColor.ON_CRITICAL : SemanticColor.TEXT);
    }

    /** All of the strip is red while the fleet is stopped: its words have the colour that can be read on that. */
    private void ink(JLabel label, SemanticColor usual) {
        LookColors.foreground(label, red ? SemanticColor.ON_CRITICAL : usual);
    }

    /** Shows what is so now; to be called a few times a second. */
    public void refresh() {
        if (red != fleetStop.isOfFleet()) {
            red = fleetStop.isOfFleet();
            style();
        }
        long running = context.models().missions().snapshot().running().stream()
                .filter(mission -> mission.parent() == Ids.NONE)
                .count();
        boolean brief = narrow.isFolded();
        int margin = Look.px(brief ? 8 : 20);
        setMarginOfStop(new Insets(Look.px(4), margin, Look.px(4), margin));
        say(missions, count(running, "mission"), brief ? String.valueOf(running) : "");
        int waiting = context.models().decisions().snapshot().size();
        say(
                decisions,
                waiting == 0 ? "nothing waits" : count(waiting, "decision"),
                brief ? String.valueOf(waiting) : "");
        showUnseen();
        ink(decisions, waiting == 0 ? SemanticColor.MUTED : SemanticColor.ACCENT);
        List<BoatSnapshot> fleet = context.models().fleet().snapshot();
        FleetCount count = FleetCount.of(fleet, context.models().unreached().snapshot());
        say(boats, context.say(count.words()), brief ? count.linked() + " / " + count.all() : "");
        ink(boats, count.linked() < count.all() ? SemanticColor.WARNING : SemanticColor.TEXT);
        showLinks(fleet, count);
        clock.setFont(brief ? Fonts.strong() : Fonts.heading());
        clock.setText(LocalTime.now(ZoneId.systemDefault()).format(CLOCK));
        showAlarms(context.models().alarms().snapshot());
        showSent();
        release.setVisible(fleetStop.isStopped() && !fleetStop.isReleasing());
        confirm.setVisible(fleetStop.isStopped() && fleetStop.isReleasing());
    }

    /** Of a stop that was pressed, what the red of the strip cannot say: that it is under way, or was not sent. */
    private void showSent() {
        Optional<String> why = fleetStop.whyNotSent();
        boolean sending = fleetStop.isSending();
        sent.setVisible(sending || why.isPresent());
        sent.setText(sending ? "stop is being sent" : "▲ STOP NOT SENT");
        String words = sending
                ? "The fleet stop is being sent"
                : "The fleet stop was NOT sent: " + why.orElse("") + ". Press it again";
        sent.setToolTipText(words);
        sent.getAccessibleContext().setAccessibleName(words);
    }

    /** Told to the layout again once the one that is under way has ended: it goes on with the width that it has asked for, and would cut the button. */
    private void setMarginOfStop(Insets margin) {
        if (!margin.equals(stop.getMargin())) {
            stop.setMargin(margin);
            EventThread.later(stop::revalidate);
        }
    }

    /** On a narrow window a number next to the icon shows it; the tooltip has the words. */
    private static void say(JLabel label, String words, String brief) {
        label.setText(brief.isEmpty() ? words : brief);
        label.setToolTipText(words);
        label.getAccessibleContext().setAccessibleName(words);
    }

    private void showLinks(List<BoatSnapshot> fleet, FleetCount count) {
        int lost = count.lost();
        long worst = fleet.stream()
                .mapToLong(boat -> boat.linkAgeMillis(context.nowMillis()).orElse(0))
                .max()
                .orElse(0);
        boolean stale = worst > BoatWords.STALE_MS;
        String age = Age.words(worst);
        say(
                links,
                lost > 0
                        ? count.lostWords()
                        : fleet.isEmpty() ? "no links" : stale ? "link stale " + age : "links fresh",
                narrow.isFolded() ? (lost > 0 ? lost + " lost" : fleet.isEmpty() ? "–" : stale ? age : "fresh") : "");
        boolean bad = lost > 0 || stale;
        SemanticColor color = bad ? SemanticColor.CRITICAL : SemanticColor.TEXT;
        links.setIcon(Icons.of(bad ? "link-lost" : "link", 16, red ? SemanticColor.ON_CRITICAL : color));
        ink(links, color);
    }

    private void showUnseen() {
        Optional<String> asked = decisionUnseen.get();
        unseen.setVisible(asked.isPresent());
        asked.ifPresent(question -> {
            unseen.setText("▲ " + question);
            unseen.setToolTipText(question + " – show it (" + keyOfDecisions + ")");
        });
    }

    private void showAlarms(List<Alarm> all) {
        AlarmCount count = AlarmCount.of(all);
        int open = count.open();
        String words = count.words();
        String mark = hasCritical(all) ? "▲ " : "△ ";
        String brief = open == 0 && count.over() > 0 ? count.over() + " over" : mark + open;
        alarms.setText(narrow.isFolded() ? brief : open == 0 ? words : mark + words);
        alarms.setToolTipText(words + " – show the alarms (" + keyOfAlarms + ")");
        alarms.getAccessibleContext().setAccessibleName(words);
        LookColors.foreground(alarms, open == 0 ? SemanticColor.MUTED : SemanticColor.ON_WARNING);
        LookColors.background(alarms, open == 0 ? SemanticColor.SURFACE : SemanticColor.WARNING_FILL);
    }

    private static boolean hasCritical(List<Alarm> all) {
        return all.stream()
                .anyMatch(alarm ->
                        alarm.active() && !alarm.acknowledged() && alarm.kind().severity() == Priority.CRITICAL);
    }

    private static String count(long number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }
}
