package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

class BoatsOfDecisionTest {
    private static final List<String> BOATS = List.of("anna", "bert", "carl");

    private static DecisionPresentation asked(String type, String prompt, Question question) {
        DecisionPresentation plain = DecisionPresenter.plain(new Decision(
                1, 1, 1, type, prompt, question, Optional.empty(), OptionalLong.empty(), Priority.MEDIUM, List.of()));
        return new DecisionPresentation(
                plain.decision(),
                plain.asker(),
                BOATS,
                plain.description(),
                plain.options(),
                plain.format(),
                plain.autonomy(),
                plain.attention(),
                plain.proposedLocation(),
                plain.map(),
                plain.approved());
    }

    @Test
    void aYesOrNoIsAboutTheBoatsThatWaitForIt() {
        assertThat(BoatsOfDecision.of(
                        asked("OperatorApprove", "Is the alarm over for dora?", new Question.Approve()),
                        Optional.empty()))
                .containsExactlyInAnyOrderElementsOf(BOATS);
    }

    @Test
    void whereValuesAreFilledInTheMapIsSeenWhole() {
        assertThat(BoatsOfDecision.of(
                        asked("OperatorCreateArea", "Draw the area", new Question.FillIn(List.of())), Optional.empty()))
                .isEmpty();
    }

    @Test
    void aQuestionAboutWaysIsAboutThoseWhosePathsWaitAndInAReplayAboutThoseThatItNames() {
        DecisionPresentation ways = asked("LongWay", "bert may not come home. Send it?", new Question.Approve());
        GeoPath path = new GeoPath(List.of(GeoPoint.of(45, 10)));

        assertThat(BoatsOfDecision.of(ways, Optional.of(new DoubtedPaths(1, Map.of("anna", path)))))
                .containsExactly("anna");
        assertThat(BoatsOfDecision.of(ways, Optional.empty())).containsExactly("bert");
    }
}
