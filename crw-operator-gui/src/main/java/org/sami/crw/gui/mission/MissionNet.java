package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.net.NetListener;
import org.sami.ui.net.NetView;

/**
 * The net of a mission with its tokens, as authors know it: what fires shines, a transition says why it does not. Sub-missions that run are one
 * choice, or a double click on their place, away.
 */
final class MissionNet extends FoldingPanel {
    private static final int LOW = 260;

    private final OperatorContext context;
    private final long root;
    private final NetView net;
    private final JComboBox<Shown> which = new JComboBox<>();
    private final JComboBox<Mode> mode = new JComboBox<>();
    private final JPanel head = new JPanel(new MigLayout("insets 4 8 4 8, hidemode 3", "[grow, 100::]push[]", "[]"));
    private final Map<Long, Long> firings = new HashMap<>();
    private MissionsSnapshot missions;
    private long drawn = Ids.NONE;
    private Optional<Plan> plan = Optional.empty();
    private Runnable menuListener = () -> {};
    private boolean filling;
    private boolean modeChosen;
    private final transient Fold low = foldBelowHeight(LOW, this::foldHead);

    /** A mission in the list of those that can be shown. */
    private record Shown(long mission, String title) {
        @Override
        public String toString() {
            return title;
        }
    }

    /** A mode in the list. */
    private record Mode(NetMode mode) {
        @Override
        public String toString() {
            return mode.label() + " parts";
        }
    }

    MissionNet(OperatorContext context, MissionsSnapshot missions, long root) {
        super(new BorderLayout());
        this.context = context;
        this.missions = missions;
        this.root = root;
        net = new NetView(context.marks());
        net.setName("mission-net");
        net.setFollowing(true);
        net.setTokenName(EngineText::token);
        net.setExplanation(this::whyNotFiring);
        net.addNetListener(new NetListener() {
            @Override
            public void opened(String id) {
                openSubMission(id);
            }
        });
        which.setName("mission-shown");
        which.getAccessibleContext().setAccessibleName("Mission or sub-mission that is shown");
        which.addActionListener(e -> draw());
        mode.setName("mission-net-mode");
        mode.getAccessibleContext().setAccessibleName("Parts of the net that are shown");
        for (NetMode each : NetMode.values()) {
            mode.addItem(new Mode(each));
        }
        mode.setSelectedItem(new Mode(net.mode()));
        mode.addActionListener(e -> {
            if (mode.getSelectedItem() instanceof Mode chosen) {
                net.setMode(chosen.mode());
                modeChosen |= !filling;
            }
        });
        head.add(which, "wmin 80, growy"); // as high as the other, so that it can be pressed
        head.add(mode, "wmin 80, hmin 40");
        add(head, BorderLayout.NORTH);
        add(net);
        show(missions);
    }

    /** Where there is hardly room for the net it has all of it: modes are left to their key, sub-missions to a menu. */
    private void foldHead(boolean hidden) {
        head.setVisible(!hidden);
        menuListener.run();
    }

    /** Calls a listener when {@link #needsMenu} may have changed. */
    void onNeedOfMenu(Runnable listener) {
        menuListener = listener;
    }

    /** Whether there are sub-missions to choose from, and no room for their list. */
    boolean needsMenu() {
        return low.isFolded() && hasSubMissions();
    }

    /** Whether anything but the mission itself can be shown. */
    boolean hasSubMissions() {
        return which.getItemCount() > 1;
    }

    /** Lets the operator choose what is shown: in the list, or, where it has no room, in a menu. */
    void choose() {
        if (low.isFolded()) {
            menu().show(this, 0, 0);
        } else {
            which.requestFocusInWindow();
            which.showPopup();
        }
    }

    private JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        menu.setName("mission-sub-mission-menu");
        for (int i = 0; i < which.getItemCount(); i++) {
            Shown shown = which.getItemAt(i);
            JRadioButtonMenuItem item = new JRadioButtonMenuItem(shown.title(), shown.equals(which.getSelectedItem()));
            item.addActionListener(e -> which.setSelectedItem(shown));
            menu.add(item);
        }
        return menu;
    }

    /** The net itself. */
    NetView view() {
        return net;
    }

    /** Shows how all stand now. */
    void show(MissionsSnapshot now) {
        missions = now;
        fill();
        draw();
    }

    private void fill() {
        List<Shown> wanted = new ArrayList<>();
        now(root).ifPresent(mission -> collect(mission, 0, wanted));
        List<Shown> there = new ArrayList<>();
        for (int i = 0; i < which.getItemCount(); i++) {
            there.add(which.getItemAt(i));
        }
        if (!wanted.equals(there)) {
            filling = true;
            Object before = which.getSelectedItem();
            which.removeAllItems();
            wanted.forEach(which::addItem);
            which.setSelectedItem(wanted.contains(before) ? before : wanted.isEmpty() ? null : wanted.get(0));
            which.setVisible(hasSubMissions());
            filling = false;
            menuListener.run();
        }
    }

    private void collect(MissionSnapshot mission, int depth, List<Shown> into) {
        into.add(new Shown(mission.id(), "   ".repeat(depth) + mission.title()));
        missions.running().stream()
                .filter(other -> other.parent() == mission.id())
                .forEach(child -> collect(child, depth + 1, into));
    }

    private Optional<MissionSnapshot> now(long mission) {
        return missions.mission(mission);
    }

    private void openSubMission(String place) {
        missions.running().stream()
                .filter(mission ->
                        mission.parent() == drawn && mission.parentPlace().equals(place))
                .findFirst()
                .ifPresent(child -> {
                    for (int i = 0; i < which.getItemCount(); i++) {
                        if (which.getItemAt(i).mission() == child.id()) {
                            which.setSelectedIndex(i);
                        }
                    }
                });
    }

    private void draw() {
        if (filling || !(which.getSelectedItem() instanceof Shown shown)) {
            return;
        }
        if (drawn != shown.mission()) {
            drawn = shown.mission();
            long wanted = drawn;
            context.shown().ask(view -> view.planOf(wanted)).thenAccept(found -> {
                if (drawn == wanted) {
                    plan = found;
                    found.ifPresent(one -> net.show(one, context.vocabulary()));
                    mark();
                    if (found.isEmpty()) {
                        drawn = Ids.NONE; // a replay stood elsewhere by then: it is asked again
                    }
                }
            });
        } else {
            mark();
        }
    }

    private void mark() {
        now(drawn).filter(mission -> plan.isPresent()).ifPresent(mission -> {
            Map<TaskId, String> robots = new HashMap<>();
            context.models()
                    .allocation()
                    .snapshot()
                    .queues()
                    .forEach((boat, tasks) -> tasks.forEach(task -> robots.put(task, boat)));
            NetMarking marking = new NetMarking(mission.marking(), mission.visitedByNobody(), robots);
            showHidden(marking);
            net.setMarking(marking);
            long before = firings.getOrDefault(drawn, mission.firings());
            long fresh = Math.max(0, mission.firings() - before); // a replay goes back as well
            List<MissionSnapshot.Firing> last = mission.lastFirings();
            last.subList((int) Math.max(0, last.size() - fresh), last.size())
                    .forEach(firing -> net.fired(firing.transition()));
            firings.put(drawn, mission.firings());
        });
    }

    /**
     * Nobody looks for boats in parts that are not shown: these are shown when a boat or a task comes there, unless the operator has
     * chosen what is.
     */
    private void showHidden(NetMarking marking) {
        Set<String> shown =
                net.scene().vertices().stream().map(NetDrawing.Vertex::id).collect(Collectors.toSet());
        if (!modeChosen
                && net.mode() == NetMode.NOMINAL
                && marking.tokens().entrySet().stream()
                        .filter(place -> !shown.contains(place.getKey()))
                        .flatMap(place -> place.getValue().stream())
                        .anyMatch(token -> !(token instanceof Token.Generic))) {
            filling = true;
            mode.setSelectedItem(new Mode(NetMode.ALL));
            filling = false;
        }
    }

    private Optional<String> whyNotFiring(String transition) {
        return now(drawn).stream()
                .flatMap(mission -> mission.details().blocked().stream())
                .flatMap(wait -> wait.transitions().stream())
                .filter(blocked -> plan.flatMap(one -> one.transition(transition))
                        .map(found -> blocked.name().equals(found.name())
                                || blocked.name().equals(found.id()))
                        .orElse(false))
                .filter(blocked -> !blocked.reasons().isEmpty())
                .map(blocked -> "Cannot fire: " + String.join("; ", blocked.reasons()))
                .findFirst();
    }
}
