package org.sami.crw.proxy.explanation;

import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;

/**
 * What became of the command that left the queue last: why a boat without commands lies where it does.
 *
 * @param cause arrived, failed or withdrawn
 * @param command empty if there never was one
 * @param why why it failed, in words; empty otherwise
 */
public record LastCommandOutcome(BoatExplanation.Cause cause, Optional<BoatCommand> command, String why) {
    public static final LastCommandOutcome NONE =
            new LastCommandOutcome(BoatExplanation.Cause.NO_COMMAND, Optional.empty(), "");

    /** The boat has carried it out. */
    public static LastCommandOutcome arrived(BoatCommand command) {
        return new LastCommandOutcome(BoatExplanation.Cause.ARRIVED, Optional.of(command), "");
    }

    /** It was given up, for a reason in words. */
    public static LastCommandOutcome failed(BoatCommand command, String why) {
        return new LastCommandOutcome(BoatExplanation.Cause.FAILED, Optional.of(command), why);
    }

    /** Its mission has taken it back. */
    public static LastCommandOutcome withdrawn(BoatCommand command) {
        return new LastCommandOutcome(BoatExplanation.Cause.WITHDRAWN, Optional.of(command), "");
    }

    /** The same in words; empty if there never was a command. */
    public Optional<String> text(MissionTitles titles) {
        return command.map(one -> ExplainedCommand.of(one, titles)).map(this::words);
    }

    private String words(ExplainedCommand words) {
        return switch (cause) {
            case ARRIVED -> "it " + words.done();
            case FAILED -> words.doing() + " failed: " + why;
            default -> words.doing() + " was withdrawn";
        };
    }
}
