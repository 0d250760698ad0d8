package org.sami.session.server;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.crw.session.Session;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.spn.value.GeoPoint;

/**
 * Carries out what people command, where their role gives the right; notes in the operator's log who did it. Driving by hand is in {@link HandDriving}.
 * For the server's thread.
 */
final class FrontCommands {
    private static final int MOST_NOTE = 500;

    private final Session session;
    private final HandDriving hand;
    private final FleetCommands fleet;
    private final SettingCommands settings;
    private final InputCommands inputs;
    private final LayerCommands layers;
    private final PeopleAnswers answering;
    private final AnswerReader answers;
    private final PeopleNews news;

    FrontCommands(Session session, SettledDecisions settled, HandDriving hand, PeopleNews news) {
        this.session = session;
        answering = new PeopleAnswers(session, settled, news);
        inputs = new InputCommands(session, answering, news);
        fleet = new FleetCommands(session.fleet(), news);
        settings = new SettingCommands(session.fleet(), news);
        layers = new LayerCommands(session);
        this.hand = hand;
        this.news = news;
        answers = new AnswerReader(session.setup().vocabulary().types());
    }

    /**
     * Carries out a command.
     *
     * @throws RefusedException in words, if it is not to be
     * @throws MalformedMessageException if members are missing
     */
    CompletionStage<CommandReply> carryOut(Front front, Person person, FrontMessage message)
            throws MalformedMessageException {
        return switch (message.type()) {
            case "answer" -> answer(person, message, true);
            case "judge" -> answer(person, message, false);
            case "hold" -> {
                Rights.require(person, Right.ANSWER);
                long decision = message.number("decision");
                yield news.noted(person, "stopped the timer of decision " + decision, session.hold(decision));
            }
            case "press" -> press(person, message);
            case "start" -> start(person, message);
            case "abort" -> {
                Rights.require(person, Right.START);
                long mission = running(message.number("mission"));
                yield news.noted(person, "aborted mission " + mission, session.abort(mission));
            }
            case "stopFleet" -> fleet.stopAll(person);
            case "releaseFleet" -> fleet.releaseAll(person);
            case "boat" -> fleet.carryOut(person, message);
            case "set" -> settings.carryOut(person, message);
            case "draft" -> inputs.judge(message);
            case "input" -> inputs.carryOut(person, message);
            case "again" -> {
                Rights.require(person, Right.START);
                long mission = running(message.number("mission"));
                yield news.noted(person, "sent again what failed in mission " + mission, session.sendAgain(mission));
            }
            case "claim", "drive", "goTo", "goHome", "holdBoat" -> {
                Rights.require(person, Right.DRIVE);
                yield hand.carryOut(front, person, message);
            }
            case "giveBack" -> hand.carryOut(front, person, message);
            case "acknowledge" -> acknowledge(person, message);
            case "note" -> note(person, message);
            case "linkedBoats" -> {
                Rights.require(person, Right.DRIVE);
                yield session.fleet().linkedBoats().thenApply(CommandReply::ofLinked);
            }
            case "linkStatuses" ->
                session.fleet().linkStatuses(message.text("boat")).thenApply(CommandReply::ofLinkStatuses);
            case "layer" -> layers.layer(message);
            case "ping" -> CompletableFuture.completedFuture(CommandReply.DONE);
            default -> throw new MalformedMessageException("'" + message.type() + "' comes first and once");
        };
    }

    private long running(long mission) {
        if (session.models()
                .missions()
                .snapshot()
                .mission(mission)
                .filter(one -> !one.hasEnded())
                .isEmpty()) {
            throw new RefusedException("No mission " + mission + " runs");
        }
        return mission;
    }

    private CompletionStage<CommandReply> answer(Person person, FrontMessage message, boolean give)
            throws MalformedMessageException {
        Rights.require(person, Right.ANSWER);
        return answering.answer(
                person,
                message.number("decision"),
                decision -> answers.read(decision, message.body().path("answer")),
                give);
    }

    private CompletionStage<CommandReply> press(Person person, FrontMessage message) throws MalformedMessageException {
        Rights.require(person, Right.PRESS);
        String name = message.text("name");
        long mission = running(message.number("mission"));
        List<String> boats = message.texts("boats");
        String whom = boats.isEmpty() ? "" : " for " + String.join(", ", boats);
        return news.noted(
                person, "pressed " + name + whom + " in mission " + mission, session.press(name, mission, boats));
    }

    private CompletionStage<CommandReply> start(Person person, FrontMessage message) throws MalformedMessageException {
        Rights.require(person, Right.START);
        String plan = message.text("plan");
        String name = message.textIfThere("name").orElse(plan);
        return session.start(plan, name, Map.of()).thenApply(mission -> {
            news.tell(person.name(), "started " + plan + " as mission " + mission);
            return CommandReply.ofMission("mission " + mission + " runs", mission);
        });
    }

    private CompletionStage<CommandReply> acknowledge(Person person, FrontMessage message)
            throws MalformedMessageException {
        Rights.require(person, Right.ANSWER);
        if (message.has("alarm")) {
            long alarm = message.number("alarm");
            session.models().alarms().acknowledge(alarm);
            news.tell(person.name(), "acknowledged alarm " + alarm);
        } else {
            long number = message.number("message");
            session.models().messages().acknowledge(number);
            news.tell(person.name(), "acknowledged message " + number);
        }
        return CompletableFuture.completedFuture(CommandReply.DONE);
    }

    private CompletionStage<CommandReply> note(Person person, FrontMessage message) throws MalformedMessageException {
        Rights.require(person, Right.ANSWER);
        String text = message.text("text").strip();
        if (text.isEmpty() || text.length() > MOST_NOTE) {
            throw new RefusedException("a note has 1 to " + MOST_NOTE + " characters");
        }
        Optional<GeoPoint> where = message.has("lat") ? Optional.of(message.point()) : Optional.empty();
        news.tell(person.name(), "notes: " + text, where);
        return CompletableFuture.completedFuture(CommandReply.DONE);
    }
}
