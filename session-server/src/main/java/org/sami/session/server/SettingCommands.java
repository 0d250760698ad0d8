package org.sami.session.server;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.session.LostLinkWish;
import org.sami.session.api.FrontFleet;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.session.record.LostLinkWishRows;

/** Sets what people ask of boats' settings, one at a time; the reply comes when the boat has taken it. For the server's thread. */
final class SettingCommands {
    private final FrontFleet fleet;
    private final PeopleNews news;

    SettingCommands(FrontFleet fleet, PeopleNews news) {
        this.fleet = fleet;
        this.news = news;
    }

    /**
     * Carries out a message {@code set}.
     *
     * @throws RefusedException in words, if it is not to be
     * @throws MalformedMessageException if members are missing
     */
    CompletionStage<CommandReply> carryOut(Person person, FrontMessage message) throws MalformedMessageException {
        Rights.require(person, Right.SETUP);
        String setting = message.text("setting");
        if (setting.equals("lost-link-wish")) {
            Optional<LostLinkAction> wish = wish(message.text("action"));
            return news.noted(person, LostLinkWish.words(wish), fleet.wishLostLink(wish));
        }
        String boat = message.text("boat");
        return switch (setting) {
            case "heading", "speed" -> {
                Gains gains = gains(message);
                yield news.noted(
                        person,
                        "set the " + setting + " gains of " + boat + " to " + gains,
                        fleet.setGains(boat, GainAxis.valueOf(setting.toUpperCase(Locale.ROOT)), gains));
            }
            case "velocity" -> {
                double multiplier = message.real("multiplier");
                yield news.noted(
                        person,
                        "set the velocity multiplier of " + boat + " to " + multiplier,
                        fleet.setVelocityMultiplier(boat, multiplier));
            }
            case "lost-link" -> {
                LostLinkAction action = action(message.text("action"));
                yield news.noted(
                        person,
                        "set " + boat + " to " + action.name().toLowerCase(Locale.ROOT) + " when its link is lost",
                        fleet.setLostLinkAction(boat, action));
            }
            default ->
                throw new MalformedMessageException(
                        "'setting' is heading, speed, velocity, lost-link or lost-link-wish");
        };
    }

    private static Gains gains(FrontMessage message) throws MalformedMessageException {
        double proportional = message.real("p");
        double integral = message.real("i");
        double derivative = message.real("d");
        try {
            return new Gains(proportional, integral, derivative);
        } catch (IllegalArgumentException unfit) {
            throw new RefusedException(String.valueOf(unfit.getMessage()));
        }
    }

    private static LostLinkAction action(String word) throws MalformedMessageException {
        return LostLinkWishRows.action(word)
                .orElseThrow(() -> new MalformedMessageException("'action' is hold, return, continue or drift"));
    }

    private static Optional<LostLinkAction> wish(String word) throws MalformedMessageException {
        if (LostLinkWishRows.isNothing(word)) {
            return Optional.empty();
        }
        return Optional.of(LostLinkWishRows.action(word)
                .orElseThrow(
                        () -> new MalformedMessageException("'action' is hold, return, continue, drift or nothing")));
    }
}
