package org.sami.crw.proxy.explanation;

import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.spn.protocol.Ids;

/**
 * Words for a command in explanations: what a boat does with it, and for whom.
 *
 * @param does present tense, such as {@code follows its path}
 * @param infinitive what it has to do
 * @param doing the command as a noun, for one that waits or fails
 * @param done past tense, for one that ended well
 */
public record ExplainedCommand(String does, String infinitive, String doing, String done) {
    private static final ExplainedCommand PATH = new ExplainedCommand(
            "follows its path", "follow its path", "following its path", "has arrived at the end of its path");
    private static final ExplainedCommand STATION = new ExplainedCommand(
            "keeps its station", "keep its station", "keeping its station", "has kept its station");
    private static final ExplainedCommand PANORAMA = new ExplainedCommand(
            "takes pictures all round",
            "take pictures all round",
            "taking pictures all round",
            "has taken its pictures all round");
    private static final ExplainedCommand STOP = new ExplainedCommand("stops", "stop", "stopping", "has stopped");

    /** An operator sent the boat to a point by hand. */
    public static final ExplainedCommand SENT = new ExplainedCommand(
            "goes where the operator sent it",
            "go where the operator sent it",
            "going where the operator sent it",
            "has arrived where the operator sent it");
    /** An operator has the boat hold its place by hand. */
    public static final ExplainedCommand HELD = new ExplainedCommand(
            "holds its place for the operator",
            "hold its place for the operator",
            "holding its place for the operator",
            "has held its place for the operator");

    /** How the id of a command begins that holds a boat while the session's engine does not work. */
    public static final String AT_FAULT = "held-";

    private static final ExplainedCommand HELD_AT_FAULT = new ExplainedCommand(
            "holds its place while the engine does not work",
            "hold its place while the engine does not work",
            "holding its place while the engine does not work",
            "has held its place while the engine did not work");

    /** How the id of a command begins that brings an aircraft home, as its charge lasts for that alone. */
    public static final String FOR_CHARGE = "charge-home-";

    private static final ExplainedCommand HOME_FOR_CHARGE = new ExplainedCommand(
            "comes home, as its charge lasts for that alone",
            "come home, as its charge lasts for that alone",
            "coming home, as its charge lasts for that alone",
            "has come home, as its charge lasted for that alone");

    /** That of a command. A command that an operator gives by hand belongs to no mission and has the same name everywhere. */
    public static ExplainedCommand of(BoatCommand command, MissionTitles titles) {
        if (command.mission() == Ids.NONE && command instanceof FollowPath) {
            return command.commandId().startsWith(FOR_CHARGE) ? HOME_FOR_CHARGE : SENT;
        } else if (command.mission() == Ids.NONE && command instanceof KeepStation) {
            return command.commandId().startsWith(AT_FAULT) ? HELD_AT_FAULT : HELD;
        }
        String whose = " for " + titles.words(command.mission());
        ExplainedCommand words = words(command);
        return new ExplainedCommand(
                words.does + whose, words.infinitive + whose, words.doing + whose, words.done + whose);
    }

    private static ExplainedCommand words(BoatCommand command) {
        if (command instanceof FollowPath) {
            return PATH;
        } else if (command instanceof KeepStation) {
            return STATION;
        }
        return command instanceof Panorama ? PANORAMA : STOP;
    }
}
