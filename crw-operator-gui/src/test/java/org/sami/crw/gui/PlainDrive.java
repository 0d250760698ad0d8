package org.sami.crw.gui;

import static org.sami.crw.gui.SessionWorld.get;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.session.Session;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/** A plan in which a boat drives to a point off Katara Beach, and nothing is planned for a path that fails: then its mission is stuck. */
final class PlainDrive {
    private static final String ID = "plain-drive";
    private static final String PLAN = """
            {'formatVersion': 1, 'id': 'plain-drive', 'name': 'P', 'domain': 'crw', 'plans': [{
              'id': 'plain-drive', 'name': 'Drive to the buoy',
              'variables': [{'name': '@points', 'type': 'map<proxy,point>'}],
              'places': [
                {'id': 'select', 'name': 'Select a boat', 'start': true, 'outputs': [
                  {'id': 'ask', 'type': 'OperatorSelectBoatList'}]},
                {'id': 'drive', 'name': 'Under way to the buoy', 'outputs': [
                  {'id': 'go', 'type': 'ProxyGotoPoint', 'fields': {'points': {'variable': '@points'}}}]},
                {'id': 'end', 'name': 'At the buoy', 'end': true}],
              'transitions': [
                {'id': 'chosen', 'name': 'Chosen', 'inputs': [{'id': 'c', 'type': 'OperatorSelectsBoatList'}]},
                {'id': 'there', 'name': 'Arrived', 'inputs': [{'id': 'i', 'type': 'ProxyPathCompleted'}]}],
              'inEdges': [
                {'id': 'ec', 'place': 'select', 'transition': 'chosen', 'requirements': [
                  {'match': 'at-least', 'n': 1, 'kind': 'generic'}, {'match': 'all', 'kind': 'relevant'}]},
                {'id': 'e', 'place': 'drive', 'transition': 'there',
                  'requirements': [{'match': 'all', 'kind': 'relevant'}]}],
              'outEdges': [
                {'id': 'oc', 'transition': 'chosen', 'place': 'drive', 'requirements': [
                  {'action': 'take', 'n': 'all', 'kind': 'relevant'}]},
                {'id': 'o', 'transition': 'there', 'place': 'end',
                  'requirements': [{'action': 'take', 'n': 'all', 'kind': 'relevant'}]}]}]}
            """;

    private PlainDrive() {}

    /** Takes the plan into the session's project, where it is not there yet. */
    private static void load(Session session) throws Exception {
        Project project = session.setup().project();
        if (project.plan(ID).isEmpty()) {
            Plan plan = SessionWorld.project(PLAN).plan(ID).orElseThrow();
            get(session.project()
                    .load(project.withPlans(Stream.concat(project.plans().stream(), Stream.of(plan))
                            .toList())));
        }
    }

    /** Starts a mission for a boat, and cancels its command: the mission is stuck when this is back. Gives the mission. */
    static long stuck(Session session, String name, String boat, GeoPoint to) throws Exception {
        load(session);
        Map<String, Value> values = Map.of("@points", new MapValue(Map.of(new ProxyValue(boat), to)));
        long mission = get(session.start(ID, name, values));
        Await.until(name + " asks", () -> decision(session, mission).isPresent());
        get(session.answer(decision(session, mission).orElseThrow(), new Answer.Proxies(List.of(boat)), "situation"));
        Await.until(
                boat + " has its command", () -> command(session, boat, mission).isPresent());
        get(session.fleet().cancel(boat, command(session, boat, mission).orElseThrow()));
        Await.until(
                name + " is stuck",
                () -> session.models()
                        .missions()
                        .snapshot()
                        .mission(mission)
                        .flatMap(one -> one.stuck())
                        .isPresent());
        return mission;
    }

    private static Optional<Long> decision(Session session, long mission) {
        return session.models().decisions().snapshot().stream()
                .map(one -> one.decision())
                .filter(one -> one.mission() == mission)
                .map(one -> one.id())
                .findFirst();
    }

    private static Optional<String> command(Session session, String boat, long mission) {
        return session.models().commands().snapshot().stream()
                .filter(one -> one.boat().equals(boat))
                .map(BoatCommands::queue)
                .flatMap(queue -> Stream.concat(queue.current().stream(), queue.waiting().stream()))
                .filter(entry -> entry.command().mission() == mission)
                .map(entry -> entry.command().commandId())
                .findFirst();
    }
}
