package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.DraftJudge;
import org.sami.session.api.Judgement;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.Value;

/** Has a session in another process judge drafts, as the engine's inputs that they would become. From any thread. */
final class RemoteDrafts implements DraftJudge {
    private final ServerRequests server;

    RemoteDrafts(ServerRequests server) {
        this.server = server;
    }

    private CompletionStage<Judgement> judge(Input input) {
        ObjectNode message = ServerRequests.message("draft");
        message.set("input", ProtocolJson.input(input));
        return server.ask(message).thenApply(RemoteDrafts::read);
    }

    private static Judgement read(JsonNode done) {
        List<Judgement.Remark> remarks = new ArrayList<>();
        done.path("remarks")
                .forEach(remark -> remarks.add(new Judgement.Remark(
                        Judgement.Kind.valueOf(remark.path("kind").asText()),
                        remark.path("words").asText())));
        return new Judgement(remarks);
    }

    @Override
    public CompletionStage<Judgement> judge(Decision decision, DraftAnswer draft) {
        return answer(decision.question(), draft)
                .map(answer -> judge(new Input.AnswerDecision(decision.id(), answer, Answerer.OPERATOR)))
                .orElse(CompletableFuture.completedFuture(Judgement.NOTHING));
    }

    private static Optional<Answer> answer(Question question, DraftAnswer draft) {
        if (question instanceof Question.FillIn) {
            return Optional.of(new Answer.Fields(draft.values()));
        } else if (question instanceof Question.ChooseProxies) {
            return Optional.of(new Answer.Proxies(draft.boats()));
        } else if (question instanceof Question.ChooseOption choose) {
            return draft.option()
                    .map(choose.options()::indexOf)
                    .filter(at -> at >= 0)
                    .map(Answer.Option::new);
        }
        return Optional.empty();
    }

    @Override
    public CompletionStage<Judgement> judgeStart(String plan, Map<String, Value> values) {
        return judge(new Input.StartMission(plan, plan, values));
    }

    @Override
    public CompletionStage<Judgement> judgeGlobal(String name, Value value) {
        return judge(new Input.SetVariable(Ids.NONE, name, value));
    }
}
