package org.sami.session.server;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.crw.session.Session;
import org.sami.session.api.Judgement;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.json.UnreadableJsonException;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;

/**
 * Commands to missions from fronts that follow the session. Each is an input of the engine; only inputs that a person may cause are carried out. For the
 * server's thread.
 */
final class InputCommands {
    private final Session session;
    private final PeopleAnswers answering;
    private final PeopleNews news;

    InputCommands(Session session, PeopleAnswers answering, PeopleNews news) {
        this.session = session;
        this.answering = answering;
        this.news = news;
    }

    /**
     * Carries it out.
     *
     * @throws RefusedException in words, if it is not to be
     * @throws MalformedMessageException if it is no input
     */
    CompletionStage<CommandReply> carryOut(Person person, FrontMessage message) throws MalformedMessageException {
        Input input = input(message);
        if (input instanceof Input.AnswerDecision answer) {
            Rights.require(person, Right.ANSWER);
            return answering.answer(person, answer.decision(), decision -> answer.answer(), true);
        } else if (input instanceof Input.HoldDecision hold) {
            Rights.require(person, Right.ANSWER);
            return news.noted(
                    person, "stopped the timer of decision " + hold.decision(), session.hold(hold.decision()));
        } else if (input instanceof Input.Interrupt press) {
            Rights.require(person, Right.PRESS);
            String whom = press.proxies().isEmpty() ? "" : " for " + String.join(", ", press.proxies());
            return news.noted(
                    person,
                    "pressed " + press.name() + whom + in(press.mission()),
                    session.press(press.name(), press.mission(), press.proxies()));
        } else if (input instanceof Input.AllocateTasks allocate) {
            Rights.require(person, Right.ANSWER);
            return move(person, allocate.allocation());
        }
        Rights.require(person, Right.START);
        return ofMissions(person, input);
    }

    /**
     * Judges an input without carrying it out; an answer in it may be half entered.
     *
     * @throws RefusedException in words, if there is nothing to judge
     * @throws MalformedMessageException if it is no input
     */
    CompletionStage<CommandReply> judge(FrontMessage message) throws MalformedMessageException {
        Input input = input(message);
        CompletionStage<Judgement> judged;
        if (input instanceof Input.AnswerDecision answer) {
            judged = answering.judge(answer.decision(), answer.answer());
        } else if (input instanceof Input.StartMission start) {
            judged = session.drafts().judgeStart(start.plan(), start.parameters());
        } else if (input instanceof Input.SetVariable set) {
            judged = session.drafts().judgeGlobal(set.variable(), set.value());
        } else {
            throw new RefusedException("there is nothing to judge about that");
        }
        return judged.thenApply(CommandReply::of);
    }

    private static Input input(FrontMessage message) throws MalformedMessageException {
        try {
            return ProtocolJson.readInput(message.body().path("input"));
        } catch (UnreadableJsonException | IllegalArgumentException unreadable) {
            throw new MalformedMessageException("'input' is no input: " + unreadable.getMessage());
        }
    }

    private static String in(long mission) {
        return mission == Ids.NONE ? " in all missions" : " in mission " + mission;
    }

    private CompletionStage<CommandReply> ofMissions(Person person, Input input) {
        if (input instanceof Input.StartMission start) {
            return session.start(start.plan(), start.name(), start.parameters()).thenApply(mission -> {
                news.tell(person.name(), "started " + start.plan() + " as mission " + mission);
                return CommandReply.ofMission("mission " + mission + " runs", mission);
            });
        } else if (input instanceof Input.AbortMission abort) {
            return abort.mission() == Ids.NONE
                    ? news.noted(person, "aborted all missions", session.abortAll())
                    : news.noted(person, "aborted mission " + abort.mission(), session.abort(abort.mission()));
        } else if (input instanceof Input.CompleteMission complete) {
            return news.noted(person, "completed mission " + complete.mission(), session.complete(complete.mission()));
        } else if (input instanceof Input.SetVariable set) {
            return news.noted(
                    person, "set " + set.variable(), session.setVariable(set.mission(), set.variable(), set.value()));
        } else if (input instanceof Input.ProxyDropped dropped) {
            return dropped.mission() == Ids.NONE
                    ? news.noted(
                            person, "took " + dropped.proxy() + " out of all missions", session.drop(dropped.proxy()))
                    : news.noted(
                            person,
                            "took " + dropped.proxy() + " out of mission " + dropped.mission(),
                            session.drop(dropped.proxy(), dropped.mission()));
        }
        throw new RefusedException("fronts do not send " + input.getClass().getSimpleName());
    }

    private CompletionStage<CommandReply> move(Person person, Map<TaskId, Optional<String>> allocation) {
        if (allocation.size() != 1) {
            return CompletableFuture.failedFuture(new RefusedException("one task is moved at a time"));
        }
        Map.Entry<TaskId, Optional<String>> one =
                allocation.entrySet().iterator().next();
        return news.noted(
                person,
                "moved task " + one.getKey().name() + " to " + one.getValue().orElse("nobody"),
                session.moveTask(one.getKey(), one.getValue()));
    }
}
