package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.until;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;

@Timeout(900)
class MissionNetTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'talk', 'name': 'Talk', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'talk'}]}],
             'plans': [{'id': 'talk', 'name': 'Talk', 'places': [
               {'id': 'ask', 'name': 'Ask', 'start': true, 'outputs': [{'id': 'q', 'type': 'OperatorApprove'}]},
               {'id': 'rest', 'name': 'Rest'}],
              'transitions': [{'id': 'yes', 'inputs': [{'id': 'i', 'type': 'YesOption'}]}],
              'inEdges': [{'id': 'a', 'place': 'ask', 'transition': 'yes',
                'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]}],
              'outEdges': [{'id': 'b', 'transition': 'yes', 'place': 'rest',
                'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]}]}]}""");

    @Test
    void theNetIsAsItWasWhenAReplayGoesBackBeforeAFiring() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            long mission = world.start("talk");
            until(
                    "it asks",
                    () -> !world.context.models().decisions().snapshot().isEmpty());
            MissionsSnapshot before = missions(world);
            MissionNet net = onEventThread(() -> new MissionNet(world.context, before, mission));
            until("the net is drawn", () -> !net.view().marking().at("ask").isEmpty());
            for (PendingDecision pending : world.context.models().decisions().snapshot()) {
                world.session.answer(pending.decision().id(), new Answer.YesNo(true), "test");
            }
            until(
                    "it has fired",
                    () -> missions(world).mission(mission).orElseThrow().firings() == 1);
            show(net, missions(world));
            assertThat(net.view().marking().at("rest")).hasSize(1);

            show(net, before);

            assertThat(net.view().marking().at("ask")).hasSize(1);
            assertThat(net.view().marking().at("rest")).isEmpty();
        }
    }

    private static MissionsSnapshot missions(SessionWorld world) {
        return world.context.models().missions().snapshot();
    }

    private static void show(MissionNet net, MissionsSnapshot now) {
        onEventThread(() -> {
            net.show(now);
            return net;
        });
    }
}
