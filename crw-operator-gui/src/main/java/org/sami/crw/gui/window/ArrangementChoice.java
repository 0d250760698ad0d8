package org.sami.crw.gui.window;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.Arrangements;
import org.sami.ui.dock.DockArea;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.window.WindowSettings;

/**
 * Which of the two arrangements a window has, kept with its settings. In the one of the thesis with one large map (AIMS) the tabs of the mission manager are
 * called as they are there: Plan, Gantt, Detect, Decisions. On the event thread.
 */
final class ArrangementChoice {
    private static final String KEY = "arrangement";
    private static final String AIMS = "aims";
    private static final Map<String, String> AIMS_TITLES =
            Map.of("missions", "Plan", "gantt", "Gantt", "interrupts", "Detect", "decisions", "Decisions");

    private final WindowSettings settings;
    private final Arrangements first;
    private final Arrangements aims;
    private final Map<DockPanel, String> titles;
    private final Consumer<Boolean> picturesOfRobots;

    /**
     * The arrangement that was chosen last.
     *
     * @param first where missions are right of the map
     * @param aims that of the thesis
     * @param titles of the panels in the first arrangement
     * @param picturesOfRobots receives whether robots are shown with their newest pictures, when another arrangement is chosen
     */
    ArrangementChoice(
            WindowSettings settings,
            Arrangements first,
            Arrangements aims,
            Map<DockPanel, String> titles,
            Consumer<Boolean> picturesOfRobots) {
        this.settings = settings;
        this.first = first;
        this.aims = aims;
        this.titles = Map.copyOf(titles);
        this.picturesOfRobots = picturesOfRobots;
    }

    private boolean isAims() {
        return AIMS.equals(settings.text(KEY));
    }

    /** How the panels lie in it. */
    Arrangements offered() {
        return isAims() ? aims : first;
    }

    /** Adds the commands that choose one, and calls the panels, which have commands by now, what they are called in the one that is chosen. */
    void addTo(DockArea dock, CommandRegistry commands) {
        commands.add(
                new Command("arrangement-first", "Missions right, decisions in sight", () -> choose("", dock, commands))
                        .withKey("ctrl alt 1"));
        commands.add(
                new Command("arrangement-aims", "Robots left, one large map (AIMS)", () -> choose(AIMS, dock, commands))
                        .withKey("ctrl alt 2"));
        nameOf(commands);
    }

    private void choose(String name, DockArea dock, CommandRegistry commands) {
        settings.keep(KEY, name);
        picturesOfRobots.accept(isAims());
        nameOf(commands);
        dock.arrange(offered());
    }

    private void nameOf(CommandRegistry commands) {
        for (DockPanel panel : List.copyOf(titles.keySet())) {
            String plain = titles.getOrDefault(panel, panel.title());
            String title = isAims() ? AIMS_TITLES.getOrDefault(panel.getPersistentID(), plain) : plain;
            if (!title.equals(panel.title())) {
                panel.retitle(title);
                commands.find("panel-" + panel.getPersistentID()).ifPresent(show -> show.retitle("Show " + title));
            }
        }
    }
}
