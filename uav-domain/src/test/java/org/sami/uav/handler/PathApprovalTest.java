package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.spn.engine.Engine;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.Session;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/** What the operator is shown of paths that are to be approved (thesis, Figure 5.6). */
class PathApprovalTest {
    private static final String COPTER = "copter1";
    private static final GeoArea AREA = new GeoArea(
            List.of(GeoPoint.of(45.7, 10.72), GeoPoint.of(45.71, 10.72), GeoPoint.of(45.71, 10.73)), List.of());
    private static final MapValue PATHS = new MapValue(
            Map.of(new ProxyValue(COPTER), new GeoPath(List.of(GeoPoint.of(45.7, 10.72), GeoPoint.of(45.71, 10.73)))));

    private final Session session = new Session(new Engine(
                    UavRuns.DOMAIN.vocabulary(),
                    UavRuns.DOMAIN.projectOf("path-approval").orElseThrow()))
            .join(COPTER);

    @Test
    void pathsThatAreToBeApprovedAreShownWithTheQuestionAndNothingElseIs() {
        session.start("path-approval");
        while (session.activations("plan").isEmpty()) {
            assertThat(shown().approved()).isEmpty();
            session.decide(answer(session.onlyDecision()));
        }
        session.step(new Input.Received(Occurrence.answer(
                "LanesPlanned", session.latest("plan"), List.of(COPTER), List.of(), Map.of("paths", PATHS))));

        assertThat(shown().question()).isEqualTo(new Question.Approve());
        assertThat(shown().approved()).containsExactly(PATHS);
    }

    private DecisionPresentation shown() {
        return DecisionPresenter.of(session.onlyDecision(), session.view());
    }

    private static Answer answer(Decision asked) {
        if (asked.question() instanceof Question.ChooseProxies) {
            return new Answer.Proxies(List.of(COPTER));
        }
        Map<String, Value> values = new LinkedHashMap<>();
        ((Question.FillIn) asked.question())
                .items()
                .forEach(item -> values.put(item.key(), item.defaultValue().orElse(AREA)));
        return new Answer.Fields(values);
    }
}
