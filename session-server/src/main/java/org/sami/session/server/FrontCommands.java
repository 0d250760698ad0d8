package org.sami.session.server;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.crw.judgement.DraftAnswer;
import org.sami.crw.judgement.Judgement;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.session.RefusedException;
import org.sami.crw.session.Session;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPoint;

/**
 * Carries out what people command, where their role gives the right; notes in the operator's log who did it. Driving by hand is in {@link HandDriving}.
 * For the server's thread.
 */
final class FrontCommands {
    private static final int MOST_NOTE = 500;

    private final Session session;
    private final SettledDecisions settled;
    private final HandDriving hand;
    private final AnswerReader answers;
    private final PeopleNews news;

    FrontCommands(Session session, SettledDecisions settled, HandDriving hand, PeopleNews news) {
        this.session = session;
        this.settled = settled;
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
                require(person, Right.ANSWER);
                long decision = message.number("decision");
                yield noted(person, "stopped the timer of decision " + decision, session.hold(decision));
            }
            case "press" -> press(person, message);
            case "start" -> start(person, message);
            case "abort" -> {
                require(person, Right.START);
                long mission = running(message.number("mission"));
                yield noted(person, "aborted mission " + mission, session.abort(mission));
            }
            case "stopFleet" ->
                noted(person, "stopped the fleet", session.fleet().stopAll());
            case "releaseFleet" -> {
                require(person, Right.PRESS);
                yield noted(person, "released the fleet", session.fleet().releaseAll());
            }
            case "claim", "drive", "goTo", "holdBoat", "giveBack" -> {
                require(person, Right.DRIVE);
                yield hand.carryOut(front, person, message);
            }
            case "acknowledge" -> acknowledge(person, message);
            case "note" -> note(person, message);
            case "ping" -> CompletableFuture.completedFuture(CommandReply.DONE);
            default -> throw new MalformedMessageException("'" + message.type() + "' comes first and once");
        };
    }

    private static void require(Person person, Right right) {
        if (!person.may(right)) {
            throw new RefusedException("The role " + person.role().word() + " of " + person.name()
                    + " does not have the right '" + right.word() + "'");
        }
    }

    private <T> CompletionStage<CommandReply> noted(Person person, String done, CompletionStage<T> what) {
        return what.thenApply(result -> {
            news.tell(person.name(), done);
            return CommandReply.DONE;
        });
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
        require(person, Right.ANSWER);
        long id = message.number("decision");
        Optional<PendingDecision> pending = session.models().decisions().find(id);
        if (pending.isEmpty()) {
            throw new RefusedException(settled.words(id));
        }
        Decision decision = pending.get().decision();
        if (!person.mayAnswer(decision)) {
            throw new RefusedException("This question is not among those of " + person.name() + " ("
                    + person.role().word() + ")");
        }
        Answer answer = answers.read(decision, message.body().path("answer"));
        Optional<String> wrong =
                session.models().decisions().check(id, answer, session.setup().vocabulary());
        if (wrong.isPresent()) {
            throw new RefusedException(wrong.get());
        }
        return session.drafts()
                .judge(decision, DraftAnswer.of(answer, decision.question()))
                .thenCompose(judged -> {
                    judged.refusal().ifPresent(why -> {
                        throw new RefusedException(why);
                    });
                    if (!give) {
                        return CompletableFuture.completedFuture(new CommandReply("", judged.doubts()));
                    }
                    return given(person, pending.get(), answer, judged);
                });
    }

    private CompletionStage<CommandReply> given(
            Person person, PendingDecision pending, Answer answer, Judgement judged) {
        long id = pending.decision().id();
        return session.answer(id, answer, person.name())
                .thenApply(nothing -> {
                    news.tell(
                            person.name(),
                            "answered [" + id + "] " + pending.presentation().title() + ": "
                                    + EngineText.answer(answer));
                    return new CommandReply("[" + id + "] is answered", judged.doubts());
                })
                .exceptionally(fault -> {
                    boolean waits = session.models().decisions().find(id).isPresent();
                    String later = settled.words(id);
                    throw new RefusedException(
                            waits || !later.contains(" already: ") ? RefusedException.reason(fault) : later);
                });
    }

    private CompletionStage<CommandReply> press(Person person, FrontMessage message) throws MalformedMessageException {
        require(person, Right.PRESS);
        String name = message.text("name");
        long mission = running(message.number("mission"));
        List<String> boats = message.texts("boats");
        String whom = boats.isEmpty() ? "" : " for " + String.join(", ", boats);
        return noted(person, "pressed " + name + whom + " in mission " + mission, session.press(name, mission, boats));
    }

    private CompletionStage<CommandReply> start(Person person, FrontMessage message) throws MalformedMessageException {
        require(person, Right.START);
        String plan = message.text("plan");
        String name = message.textIfThere("name").orElse(plan);
        return session.start(plan, name, Map.of()).thenApply(mission -> {
            news.tell(person.name(), "started " + plan + " as mission " + mission);
            return CommandReply.of("mission " + mission + " runs");
        });
    }

    private CompletionStage<CommandReply> acknowledge(Person person, FrontMessage message)
            throws MalformedMessageException {
        require(person, Right.ANSWER);
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
        require(person, Right.ANSWER);
        String text = message.text("text").strip();
        if (text.isEmpty() || text.length() > MOST_NOTE) {
            throw new RefusedException("a note has 1 to " + MOST_NOTE + " characters");
        }
        Optional<GeoPoint> where = message.has("lat") ? Optional.of(message.point()) : Optional.empty();
        news.tell(person.name(), "notes: " + text, where);
        return CompletableFuture.completedFuture(CommandReply.DONE);
    }
}
