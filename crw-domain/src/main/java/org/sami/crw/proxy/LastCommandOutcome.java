package org.sami.crw.proxy;

/**
 * What became of the command that left the queue last: why a boat of which nothing is wanted lies where it does.
 *
 * @param cause arrived, failed or withdrawn
 * @param text in words
 */
record LastCommandOutcome(BoatExplanation.Cause cause, String text) {
    static final LastCommandOutcome NONE = new LastCommandOutcome(BoatExplanation.Cause.NO_COMMAND, "");

    static LastCommandOutcome arrived(BoatCommand command) {
        if (command instanceof Panorama) {
            return new LastCommandOutcome(
                    BoatExplanation.Cause.ARRIVED, "it has taken the pictures of " + name(command));
        }
        String done = command instanceof Stop ? "has stopped, as " : "has arrived at the end of ";
        String wished = command instanceof Stop ? " wanted" : "";
        return new LastCommandOutcome(BoatExplanation.Cause.ARRIVED, "it " + done + name(command) + wished);
    }

    static LastCommandOutcome failed(BoatCommand command, String why) {
        return new LastCommandOutcome(BoatExplanation.Cause.FAILED, name(command) + " failed: " + why);
    }

    static LastCommandOutcome withdrawn(BoatCommand command) {
        return new LastCommandOutcome(BoatExplanation.Cause.WITHDRAWN, name(command) + " was withdrawn");
    }

    private static String name(BoatCommand command) {
        return command.commandId() + " of mission " + command.mission();
    }
}
