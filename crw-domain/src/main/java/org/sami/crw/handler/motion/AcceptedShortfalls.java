package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.service.Geodesy;
import org.sami.spn.host.EngineHost;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * For which flights the operator has accepted that the charge may not last, and by how much: the way to a task, and what is done there, are one flight, and so are the way to a
 * place and what is done at it. That counts until the aircraft is on the ground again, and unless it has become clearly worse. For the fleet's thread.
 */
final class AcceptedShortfalls implements AircraftMemory.Part {
    /** So much longer than was accepted the charge may fall short, in seconds: 4 % of a battery that lasts 25 minutes. */
    private static final double WORSE_S = 60;

    private static final double SAME_PLACE_M = 15; // within which an aircraft stays at a place that it has reached

    private final List<Accepted> all = new ArrayList<>();
    private final Set<String> flown = new HashSet<>(); // aircraft that took off since

    private record Accepted(Addressee robot, long mission, GeoPoint end, double shortfallS) {
        boolean isOf(Addressee other, long otherMission, GeoPoint otherEnd) {
            boolean same = robot.boat().equals(other.boat()) && mission == otherMission;
            return same
                    && robot.tasks().equals(other.tasks())
                    && (!robot.tasks().isEmpty() || Geodesy.distanceM(end, otherEnd) < SAME_PLACE_M);
        }
    }

    /** The operator sends an aircraft whose charge falls short by so many seconds. */
    void add(Addressee robot, long mission, GeoPoint end, double shortfallS) {
        all.removeIf(one -> one.isOf(robot, mission, end));
        all.add(new Accepted(robot, mission, end, shortfallS));
    }

    /** Whether the operator knows about a flight that its charge falls short by so many seconds, or by not many more. */
    boolean covers(Addressee robot, long mission, GeoPoint end, double shortfallS) {
        return all.stream().anyMatch(one -> one.isOf(robot, mission, end) && shortfallS <= one.shortfallS() + WORSE_S);
    }

    @Override
    public String prefix() {
        return "accepted-flights/";
    }

    /** Whether it has taken off since, and each flight. */
    @Override
    public ListValue of(String aircraft) {
        List<Value> values = new ArrayList<>();
        for (Accepted one : all) {
            if (one.robot().boat().equals(aircraft)) {
                values.add(new ListValue(List.of(
                        new IntegerValue(one.mission()),
                        new ListValue(List.copyOf(one.robot().tasks())),
                        one.end(),
                        new RealValue(one.shortfallS()))));
            }
        }
        if (!values.isEmpty()) {
            values.add(0, new BooleanValue(flown.contains(aircraft)));
        }
        return new ListValue(values);
    }

    @Override
    public void goOn(String aircraft, ListValue before, EngineHost host) {
        for (Value value : before.items()) {
            if (value.equals(new BooleanValue(true))) {
                flown.add(aircraft);
            } else if (value instanceof ListValue one
                    && one.items().size() == 4
                    && one.items().get(0) instanceof IntegerValue mission
                    && one.items().get(1) instanceof ListValue tasks
                    && one.items().get(2) instanceof GeoPoint end
                    && one.items().get(3) instanceof RealValue shortfallS) {
                List<TaskId> names = tasks.items().stream()
                        .filter(TaskId.class::isInstance)
                        .map(TaskId.class::cast)
                        .toList();
                add(new Addressee(aircraft, names.isEmpty(), names), mission.value(), end, shortfallS.value());
            }
        }
    }

    /** Where an aircraft is: once it is on the ground again, its next flight is another one. */
    void isAt(String aircraft, boolean onTheGround) {
        if (!onTheGround) {
            flown.add(aircraft);
        } else if (flown.remove(aircraft)) {
            all.removeIf(one -> one.robot().boat().equals(aircraft));
        }
    }
}
