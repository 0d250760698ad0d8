package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.until;

import javax.swing.JComboBox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.picture.net.NetMode;
import org.sami.spn.model.Project;

@Timeout(900)
class MissionNetModeTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'rescue'}]}],
             'plans': [
              {'id': 'rescue', 'name': 'Rescue', 'places': [
                {'id': 'go', 'name': 'Go', 'start': true},
                {'id': 'adrift', 'name': 'Adrift', 'mode': 'recovery'}],
               'transitions': [{'id': 'lost', 'name': 'Lost', 'mode': 'recovery'}],
               'inEdges': [{'id': 'a', 'place': 'go', 'transition': 'lost', 'mode': 'recovery',
                 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'any-proxy'}]}],
               'outEdges': [{'id': 'b', 'transition': 'lost', 'place': 'adrift', 'mode': 'recovery',
                 'requirements': [{'action': 'take', 'n': 'all', 'kind': 'any-proxy'}]}]}
             ]}""");

    @Test
    void partsThatAreNotShownAreShownWhenABoatComesThere() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            long mission = world.start("rescue");
            until(
                    "the mission is known",
                    () -> world.context
                            .models()
                            .missions()
                            .snapshot()
                            .mission(mission)
                            .isPresent());
            MissionNet net = laidOut(() -> new MissionNet(
                    world.context, world.context.models().missions().snapshot(), mission));

            until("all parts are shown", () -> net.view().mode() == NetMode.ALL);
            assertThat(onEventThread(() -> find(net, "mission-net-mode", JComboBox.class)
                            .getSelectedItem()
                            .toString()))
                    .isEqualTo("All parts");
        }
    }
}
