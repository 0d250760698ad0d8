package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.session.api.Judgement;
import org.sami.session.api.Judgement.Kind;
import org.sami.session.api.Judgement.Remark;
import org.sami.spn.protocol.Priority;

/** What the models of a session on copters say. */
class CopterModelsTest {
    private final OperatorModels models = new OperatorModels(Runnable::run, () -> 0, Runnable::run, RobotKind.COPTER);

    @Test
    void faultsSpeakOfCopters() {
        models.health()
                .report(HealthFault.of(
                        HealthKind.ALARM,
                        "copter1",
                        Priority.HIGH,
                        "The boat drives",
                        "Stop the boat, or send it back into its water"));

        assertThat(models.health().snapshot().entries())
                .singleElement()
                .extracting(entry -> entry.fault().whole())
                .isEqualTo("The copter flies. Stop the copter, or send it back into its area.");
    }

    @Test
    void logSpeaksOfCoptersAndLeavesNotesAlone() {
        models.log().add(OperatorLogEntry.Kind.BOAT, "added simulated boats: copter6", "copter6");
        models.log().add(OperatorLogEntry.Kind.NOTE, "a boat lies below");

        assertThat(models.log().snapshot())
                .extracting(OperatorLogEntry::text)
                .containsExactly("added simulated copters: copter6", "a boat lies below");
    }

    @Test
    void judgementsSpeakOfCopters() {
        Judgement judged = new Judgement(List.of(new Remark(Kind.COST, "2 boats")));

        assertThat(judged.inWordsFor(RobotKind.COPTER).costs()).containsExactly("2 copters");
    }
}
