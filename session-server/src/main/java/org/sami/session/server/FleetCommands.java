package org.sami.session.server;

import java.util.concurrent.CompletionStage;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Fleet;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.spn.value.GeoPoint;

/** What people do with single boats and with the fleet, apart from driving them by hand. For the server's thread. */
final class FleetCommands {
    private final Fleet fleet;
    private final PeopleNews news;

    FleetCommands(Fleet fleet, PeopleNews news) {
        this.fleet = fleet;
        this.news = news;
    }

    /** Stops every boat: everybody's. */
    CompletionStage<CommandReply> stopAll(Person person) {
        return fleet.stopAll().thenApply(boats -> {
            news.tell(person.name(), "stopped the fleet");
            return CommandReply.ofBoats(boats);
        });
    }

    /** Ends the fleet stop. */
    CompletionStage<CommandReply> releaseAll(Person person) {
        Rights.require(person, Right.PRESS);
        return fleet.releaseAll().thenApply(boats -> {
            news.tell(person.name(), "released the fleet");
            return CommandReply.ofBoats(boats);
        });
    }

    /**
     * Carries out a message {@code boat}.
     *
     * @throws RefusedException in words, if it is not to be
     * @throws MalformedMessageException if members are missing
     */
    CompletionStage<CommandReply> carryOut(Person person, FrontMessage message) throws MalformedMessageException {
        String what = message.text("do");
        switch (what) {
            case "stop" -> {
                String boat = message.text("boat");
                return news.noted(person, "stopped " + boat, fleet.stop(boat));
            }
            case "release" -> {
                Rights.require(person, Right.PRESS);
                String boat = message.text("boat");
                return news.noted(person, "released " + boat, fleet.release(boat));
            }
            case "take", "ask", "watch", "give", "clear", "cancel", "resend" -> {
                Rights.require(person, Right.DRIVE);
                return command(person, what, message.text("boat"), message);
            }
            case "connect", "disconnect", "add" -> {
                Rights.require(person, Right.START);
                return which(person, what, message);
            }
            default ->
                throw new MalformedMessageException(
                        "'do' is stop, release, take, ask, watch, give, clear, cancel, resend, connect, disconnect or"
                                + " add");
        }
    }

    private CompletionStage<CommandReply> command(Person person, String what, String boat, FrontMessage message)
            throws MalformedMessageException {
        return switch (what) {
            case "take" -> news.noted(person, "took the command of " + boat, fleet.takeCommand(boat));
            case "ask" -> news.noted(person, "asked for the command of " + boat, fleet.askForCommand(boat));
            case "clear" -> news.noted(person, "cleared the block of " + boat, fleet.clearBlock(boat));
            case "resend" -> news.noted(person, "sent the path of " + boat + " again", fleet.sendPathAgain(boat));
            case "cancel" -> {
                String command = message.text("command");
                yield news.noted(person, "cancelled " + command + " of " + boat, fleet.cancel(boat, command));
            }
            case "watch" -> news.noted(person, "only watches " + boat, fleet.handOver(boat));
            default -> {
                String client = message.text("client");
                yield news.noted(person, "gave the command of " + boat + " to " + client, fleet.handOver(boat, client));
            }
        };
    }

    private CompletionStage<CommandReply> which(Person person, String what, FrontMessage message)
            throws MalformedMessageException {
        if (what.equals("connect")) {
            BoatAddress address = address(message.text("address"));
            news.tell(person.name(), "connects to " + address);
            return fleet.connect(address).thenApply(CommandReply::of);
        } else if (what.equals("add")) {
            GeoPoint at = message.point();
            int count = (int) Math.min(Integer.MAX_VALUE, message.number("count"));
            return fleet.addSimulated(message.text("boat"), at, count).thenApply(boats -> {
                news.tell(person.name(), "added simulated boats: " + String.join(", ", boats));
                return CommandReply.ofBoats(boats);
            });
        }
        CompletionStage<Boolean> known = message.has("address")
                ? fleet.disconnect(address(message.text("address")))
                : fleet.disconnect(message.text("boat"));
        String which = message.has("address") ? message.text("address") : message.text("boat");
        return known.thenApply(was -> {
            if (!was) {
                throw new RefusedException("there is no boat '" + which + "'");
            }
            news.tell(person.name(), "disconnected " + which);
            return CommandReply.DONE;
        });
    }

    private static BoatAddress address(String text) {
        try {
            return BoatAddress.parse(text);
        } catch (IllegalArgumentException unfit) {
            throw new RefusedException(String.valueOf(unfit.getMessage()));
        }
    }
}
