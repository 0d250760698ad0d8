package org.sami.crw.proxy;

/**
 * What became of the command that left the queue last: why a boat of which nothing is wanted lies where it does.
 *
 * @param cause arrived, failed or withdrawn
 * @param text in words
 */
record LastWord(Explanation.Cause cause, String text) {
    static final LastWord NONE = new LastWord(Explanation.Cause.NO_COMMAND, "");

    static LastWord arrived(BoatCommand command) {
        if (command instanceof Panorama) {
            return new LastWord(Explanation.Cause.ARRIVED, "it has taken the pictures of " + name(command));
        }
        String done = command instanceof Stop ? "has stopped, as " : "has arrived at the end of ";
        String wished = command instanceof Stop ? " wanted" : "";
        return new LastWord(Explanation.Cause.ARRIVED, "it " + done + name(command) + wished);
    }

    static LastWord failed(BoatCommand command, String why) {
        return new LastWord(Explanation.Cause.FAILED, name(command) + " failed: " + why);
    }

    static LastWord withdrawn(BoatCommand command) {
        return new LastWord(Explanation.Cause.WITHDRAWN, name(command) + " was withdrawn");
    }

    private static String name(BoatCommand command) {
        return command.commandId() + " of mission " + command.mission();
    }
}
