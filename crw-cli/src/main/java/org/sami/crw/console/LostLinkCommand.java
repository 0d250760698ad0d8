package org.sami.crw.console;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.alarm.LaunchCheck;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.session.Session;
import org.sami.session.api.FrontFleet;
import org.sami.session.api.RefusedException;

/** The command that compares what boats do when their link is lost with what the session wishes, and sets it. */
final class LostLinkCommand {
    private static final String NOTHING = "nothing";
    private static final String SET = "set";

    private final ConsoleContext context;

    LostLinkCommand(ConsoleContext context) {
        this.context = context;
    }

    /** What it takes. */
    static List<String> words() {
        List<String> words = new ArrayList<>();
        for (LostLinkAction action : LostLinkAction.values()) {
            words.add(word(action));
        }
        words.add(NOTHING);
        words.add(SET);
        return words;
    }

    private static String word(LostLinkAction action) {
        return action.name().toLowerCase(Locale.ROOT);
    }

    void run(Arguments arguments, Consumer<String> out) {
        String asked = arguments.hasNext() ? arguments.next("action") : "";
        arguments.end();
        FrontFleet fleet = context.session().fleet();
        if (asked.equals(SET)) {
            set(fleet, out);
        } else if (!asked.isEmpty()) {
            context.await(fleet.wishLostLink(wish(asked)));
        }
        say(fleet, out);
    }

    private static Optional<LostLinkAction> wish(String asked) {
        if (asked.equals(NOTHING)) {
            return Optional.empty();
        }
        return Optional.of(Stream.of(LostLinkAction.values())
                .filter(action -> word(action).equals(asked))
                .findFirst()
                .orElseThrow(() -> new ConsoleFault("'" + asked + "' is none of " + String.join(", ", words()))));
    }

    private void set(FrontFleet fleet, Consumer<String> out) {
        LostLinkAction wish = fleet.lostLinkWish()
                .orElseThrow(() -> new ConsoleFault("the session wishes nothing: say what, such as lost-link return"));
        for (BoatSnapshot boat : context.models().fleet().snapshot()) {
            if (LaunchCheck.isAgainstWish(boat, Optional.of(wish))) {
                set(fleet, boat.boat(), wish, out);
            }
        }
    }

    private void set(FrontFleet fleet, String boat, LostLinkAction wish, Consumer<String> out) {
        try {
            context.await(fleet.setLostLinkAction(boat, wish));
            out.accept(boat + " is set, as it has confirmed");
        } catch (RefusedException | ConsoleFault refused) {
            out.accept(boat + " is not set: " + refused.getMessage());
        }
    }

    private void say(FrontFleet fleet, Consumer<String> out) {
        out.accept(fleet.lostLinkWish()
                .map(wish -> "wished: without a link a boat " + LostLinkWords.of(wish))
                .orElse("nothing is wished"));
        for (BoatSnapshot boat : context.models().fleet().snapshot()) {
            own(boat).ifPresent(own -> out.accept(boat.boat() + " " + LaunchCheck.lostLink(own, fleet.lostLinkWish())));
        }
    }

    /** What is in force on it; in the session's own process also what was set just now, which models know a moment later. */
    private Optional<BoatTuning> own(BoatSnapshot boat) {
        return Session.inProcess(context.session())
                .map(here -> context.await(here.fleet().settings(boat.boat())))
                .orElseGet(boat::settings);
    }
}
