package org.sami.session.server;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.session.Session;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;

/** Judges the answers of people and gives them to the session. The second person to answer a decision is told who was first. For the server's thread. */
final class PeopleAnswers {
    private final Session session;
    private final SettledDecisions settled;
    private final PeopleNews news;

    PeopleAnswers(Session session, SettledDecisions settled, PeopleNews news) {
        this.session = session;
        this.settled = settled;
        this.news = news;
    }

    /**
     * Answers, or only judges the answer.
     *
     * @param read gives the answer to the decision that waits
     * @throws RefusedException in words, if the decision waits no longer, is not the person's, or the answer does not fit
     */
    CompletionStage<CommandReply> answer(Person person, long id, Function<Decision, Answer> read, boolean give) {
        Optional<PendingDecision> pending = session.models().decisions().find(id);
        if (pending.isEmpty()) {
            throw new RefusedException(settled.words(id));
        }
        Decision decision = pending.get().decision();
        if (!person.mayAnswer(decision)) {
            throw new RefusedException("This question is not among those of " + person.name() + " ("
                    + person.role().word() + ")");
        }
        Answer answer = read.apply(decision);
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
                        return CompletableFuture.completedFuture(CommandReply.of("", judged.doubts()));
                    }
                    return given(person, pending.get(), answer, judged);
                });
    }

    /** Judges an answer that may be half entered. Has no remarks where the decision waits no longer. */
    CompletionStage<Judgement> judge(long id, Answer draft) {
        return session.models()
                .decisions()
                .find(id)
                .map(PendingDecision::decision)
                .map(decision -> session.drafts().judge(decision, DraftAnswer.of(draft, decision.question())))
                .orElseGet(() -> CompletableFuture.completedFuture(Judgement.NOTHING));
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
                    return CommandReply.of("[" + id + "] is answered", judged.doubts());
                })
                .exceptionally(fault -> {
                    boolean waits = session.models().decisions().find(id).isPresent();
                    String later = settled.words(id);
                    throw new RefusedException(
                            waits || !later.contains(" already: ") ? RefusedException.reason(fault) : later);
                });
    }
}
