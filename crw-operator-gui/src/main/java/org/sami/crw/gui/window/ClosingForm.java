package org.sami.crw.gui.window;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.RobotIcons;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.session.BoatsAtEnd;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Ids;
import org.sami.ui.look.Icons;
import org.sami.ui.value.WrappedText;

/** Asks in place what boats shall do as the window is closed while missions run. The focus is on the answer that closes nothing. */
final class ClosingForm extends JPanel {
    private static final String WIDE = "span, growx, wmin 60";

    private final OperatorContext context;
    private final WrappedText without;

    /**
     * The question.
     *
     * @param chosen is given what boats shall do, to close then
     * @param stay closes the question
     */
    ClosingForm(OperatorContext context, Consumer<BoatsAtEnd> chosen, Runnable stay) {
        super(new MigLayout("novisualpadding, insets 4 12 12 12, gap 8, fillx, wrap 1, w 560::", "[grow,fill]"));
        this.context = context;
        without = new WrappedText(context.say("What boats do without a link is being asked of them."));
        setName("closing");
        List<String> running = context.models().missions().snapshot().running().stream()
                .filter(mission -> mission.parent() == Ids.NONE)
                .map(MissionSnapshot::title)
                .toList();
        WrappedText what =
                new WrappedText((running.size() == 1 ? "1 mission runs: " : running.size() + " missions run: ")
                        + String.join(", ", running)
                        + context.say(
                                ". What shall boats do? The session is offered again when the window is opened next."));
        what.setName("closing-missions");
        without.setName("closing-without-link");
        without.setColor(SemanticColor.MUTED);
        add(what, WIDE);
        JButton stays = button("closing-stay", "Do not close", "check", "Everything goes on (Escape)");
        stays.addActionListener(e -> stay.run());
        add(stays, "hmin 40");
        add(
                choice(
                        "closing-hold",
                        "Close; each boat holds its place",
                        RobotIcons.hold(context.robots()),
                        chosen,
                        BoatsAtEnd.HOLD),
                "hmin 40, gaptop 8");
        add(
                choice("closing-stop", "Close; boats stop their motors and drift", "stop", chosen, BoatsAtEnd.STOP),
                "hmin 40");
        add(
                choice(
                        "closing-go-on",
                        "Close; boats continue with their last commands",
                        "play",
                        chosen,
                        BoatsAtEnd.GO_ON),
                "hmin 40");
        add(without, WIDE);
        askSettings();
    }

    private JButton choice(String name, String ofBoats, String icon, Consumer<BoatsAtEnd> chosen, BoatsAtEnd what) {
        String words = context.say(ofBoats);
        JButton button = button(name, words, icon, words);
        button.addActionListener(e -> chosen.accept(what));
        return button;
    }

    private static JButton button(String name, String words, String icon, String tip) {
        JButton button = new JButton(words, Icons.normal(icon));
        button.setName(name);
        button.setHorizontalAlignment(JButton.LEADING);
        button.setToolTipText(tip);
        return button;
    }

    /** Says what each boat does once it notices that its link is lost, as the boats say it. */
    private void askSettings() {
        Map<LostLinkAction, Set<String>> actions = new TreeMap<>();
        Set<String> unknown = new TreeSet<>();
        context.models().fleet().snapshot().forEach(boat -> {
            unknown.add(boat.boat());
            context.here()
                    .fleet()
                    .settings(boat.boat())
                    .thenAccept(tuning -> tuning.ifPresent(said -> {
                        unknown.remove(boat.boat());
                        actions.computeIfAbsent(said.lostLinkAction(), action -> new TreeSet<>())
                                .add(boat.boat());
                        say(actions, unknown);
                    }));
        });
        say(actions, unknown);
    }

    private void say(Map<LostLinkAction, Set<String>> actions, Set<String> unknown) {
        String known = actions.entrySet().stream()
                .map(each -> String.join(", ", each.getValue()) + ": " + context.say(LostLinkWords.of(each.getKey())))
                .collect(Collectors.joining("; "));
        String others = unknown.isEmpty() ? "" : String.join(", ", unknown) + ": not known";
        without.setText(context.say(
                        "Simulated boats of this window end with it. Others notice that the link is gone, and then do"
                                + " what is set for that")
                + (known.isEmpty() && others.isEmpty()
                        ? "."
                        : " – " + known + (known.isEmpty() || others.isEmpty() ? "" : "; ") + others + "."));
        revalidate();
    }
}
