package org.sami.crw.gui.remote;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import org.sami.session.client.PersonRights;
import org.sami.ui.command.CommandPolicy;

/**
 * Locks the commands for which a person lacks the right in a session elsewhere, so that nobody presses what its server would refuse. The fleet stop is
 * everybody's.
 */
final class RightsPolicy implements CommandPolicy {
    private static final Pattern INTERRUPT = Pattern.compile("interrupt-[0-9]+"); // as many as missions have

    /** The commands of each right, and what they do in words. */
    private enum Needed {
        ANSWER(
                "answer decisions",
                "decision-answer",
                "decision-refuse",
                "decision-stop-timer",
                "decision-draw",
                "alarm-acknowledge",
                "message-acknowledge",
                "allocation-give",
                "interrupt-withdraw"), // which answers what it asks
        PRESS(
                "press interrupts, or release boats",
                "fleet-release",
                "fleet-release-confirm",
                "boat-release",
                "interrupt-confirm"),
        START(
                "start or end missions, or connect boats",
                "mission-start",
                "mission-start-with",
                "mission-abort",
                "mission-complete",
                "mission-end-confirm",
                "mission-send-again",
                "global-set",
                "boat-connect",
                "boat-disconnect",
                "boat-add-simulated",
                "address-give-up"),
        DRIVE(
                "drive boats or fetch their logs",
                "boat-by-hand",
                "boat-try-motor",
                "boat-take",
                "boat-hand-over",
                "boat-resend",
                "boat-clear-block",
                "boat-cancel-command",
                "boats-go",
                "boats-home",
                "boats-hold",
                "boats-give-back",
                "logs-fetch"),
        SETUP(
                "set up boats",
                "boat-set-heading",
                "boat-set-speed",
                "boat-set-velocity",
                "boat-set-lost-link",
                "boat-set-lost-link-wish",
                "boat-set-wished-lost-link");

        private final String words;
        private final List<String> commands;

        Needed(String words, String... commands) {
            this.words = words;
            this.commands = List.of(commands);
        }

        private boolean isFor(String id) {
            return commands.contains(id)
                    || (this == PRESS && INTERRUPT.matcher(id).matches());
        }

        private String right() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    private final Supplier<PersonRights> person;

    /** Locks what a person may not do at the time. */
    RightsPolicy(Supplier<PersonRights> person) {
        this.person = person;
    }

    @Override
    public Optional<String> whyLocked(String id) {
        PersonRights now = person.get();
        return Arrays.stream(Needed.values())
                .filter(needed -> needed.isFor(id) && !now.has(needed.right()))
                .findFirst()
                .map(needed -> "your role in this session, " + now.role() + ", may not " + needed.words);
    }
}
