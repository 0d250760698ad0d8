package org.sami.crw.gui.boat;

import java.util.Locale;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.explanation.ExplainedCommand;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.spn.protocol.Ids;

/** What panels say of a boat's commands. */
public final class CommandWords {
    private CommandWords() {}

    /** What is to be done, such as {@code follow a path of 9}. */
    public static String what(BoatCommand command) {
        if (command.mission() == Ids.NONE && !(command instanceof Stop)) {
            return ExplainedCommand.of(command, MissionTitles.NONE).infinitive();
        } else if (command instanceof FollowPath path) {
            int points = path.points().size();
            return points == 1 ? "go to a point" : "follow a path of " + points + " points";
        } else if (command instanceof KeepStation) {
            return "keep station";
        } else if (command instanceof Panorama) {
            return "take pictures all round";
        } else if (command instanceof Stop) {
            return "stop";
        }
        return "something this window does not know";
    }

    /** The same and how far it is. */
    public static String progress(Entry entry) {
        return what(entry.command()) + (entry.points() > 1 ? " (" + entry.visited() + " of them done)" : "");
    }

    /** The command, its mission, its priority, and whether the mission keeps the boat afterwards. */
    static String full(Entry entry, MissionTitles titles) {
        BoatCommand command = entry.command();
        return what(command) + (command.mission() == Ids.NONE ? "" : ", " + titles.words(command.mission())) + ", "
                + command.priority().name().toLowerCase(Locale.ROOT)
                + (command.block() ? ", keeps the boat" : "");
    }
}
