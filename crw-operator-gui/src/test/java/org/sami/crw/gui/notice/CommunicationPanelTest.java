package org.sami.crw.gui.notice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;
import static org.sami.crw.gui.SessionWorld.text;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.spn.model.Project;

@Timeout(900)
class CommunicationPanelTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'statuses', 'name': 'Statuses', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'warns'}, {'plan': 'alarms'}]}],
             'plans': [
              {'id': 'warns', 'name': 'Warns', 'places': [
                {'id': 'say', 'name': 'Say', 'start': true, 'outputs': [
                  {'id': 'm', 'type': 'DisplayMessage', 'fields': {'message': {'value': 'news'}},
                   'markups': [{'type': 'ProxyStatus', 'options': {'status': 'WARNING'}}]}]}],
               'transitions': [], 'inEdges': [], 'outEdges': []},
              {'id': 'alarms', 'name': 'Alarms', 'places': [
                {'id': 'say', 'name': 'Say', 'start': true, 'outputs': [
                  {'id': 'm', 'type': 'DisplayMessage', 'fields': {'message': {'value': 'news'}},
                   'markups': [{'type': 'ProxyStatus', 'options': {'status': 'SEVERE'}}]}]}],
               'transitions': [], 'inEdges': [], 'outEdges': []}
            ]}""");

    @Test
    void aBoatIsAsBadAsItsWorstMissionSaysAndGreenAgainWhenThatHasEnded() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            CommunicationPanel panel = laidOut(() -> new CommunicationPanel(world.context));
            until(panel, "anna|● nominal|");

            world.start("warns");
            until(panel, "anna|△ warning|");
            assertThat(text(panel, "communication-summary")).startsWith("△ 0 severe  ·  1 warning");

            long alarms = world.start("alarms");
            until(panel, "anna|▲ severe|");
            assertThat(rows(panel, "communication-table"))
                    .contains("Warns (1): warning since ")
                    .contains("Alarms (2): severe since ");

            SessionWorld.get(world.session.abort(alarms));
            until(panel, "anna|△ warning|");
        }
    }

    private static void until(CommunicationPanel panel, String row) {
        SessionWorld.until(row + " is shown", () -> {
            panel.refresh();
            return rows(panel, "communication-table").startsWith(row);
        });
    }
}
