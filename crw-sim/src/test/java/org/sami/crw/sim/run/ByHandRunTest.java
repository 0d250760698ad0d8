package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.CommandMessage;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.sim.fleet.ExecutedCommand;
import org.sami.crw.sim.run.settings.RunPlan;

/** What an operator wants of boats by hand, in runs in process. */
class ByHandRunTest {
    private static final String BOAT = "boat1";

    /** The commands that a boat executed, which is held at the first look after its mission has begun and then given back. */
    private static List<String> executed() {
        RunPlan plan = TestRuns.plan("clv");
        InProcessRun run =
                new InProcessRun(plan, TestRuns.settings(plan, 2, 4, 1), AnswersFile.EMPTY, RunJournal.none());
        List<Integer> looks = new ArrayList<>();
        run.run(
                Pacer.UNPACED,
                new RunObserver(
                        progress -> {
                            looks.add(looks.size());
                            if (looks.size() == 200) {
                                run.session().byHand().hold(BOAT);
                            } else if (looks.size() == 400) {
                                run.session().byHand().giveBack(BOAT);
                            }
                        },
                        () -> false));
        return run.water().fleet().boat(BOAT).orElseThrow().executed().stream()
                .map(ExecutedCommand::command)
                .map(CommandMessage::commandId)
                .toList();
    }

    @Test
    void equalWishesAtEqualTimesAreEqualCommands() {
        List<String> once = executed();

        assertThat(once).anyMatch(command -> command.startsWith("guided-"));
        assertThat(executed()).isEqualTo(once);
    }
}
