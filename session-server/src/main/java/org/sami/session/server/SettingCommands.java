package org.sami.session.server;

import java.util.Locale;
import java.util.concurrent.CompletionStage;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.session.FrontFleet;
import org.sami.crw.session.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;

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
        String boat = message.text("boat");
        String setting = message.text("setting");
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
            default -> throw new MalformedMessageException("'setting' is heading, speed, velocity or lost-link");
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
        for (LostLinkAction action : LostLinkAction.values()) {
            if (action.name().toLowerCase(Locale.ROOT).equals(word)) {
                return action;
            }
        }
        throw new MalformedMessageException("'action' is hold, return, continue or drift");
    }
}
