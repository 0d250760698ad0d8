package org.sami.session.rows;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.session.Session;
import org.sami.session.person.Person;
import org.sami.spn.host.Registration;

/** The tables of a session, from the snapshots of its models. Tables that are for everybody are made once for all fronts. For one thread. */
public final class SessionRows implements AutoCloseable {
    private static final long BOATS_MS = 100;
    private static final long MS_PER_BOAT = 4; // about 100 kB/s for a large fleet

    private final Session session;
    private final OperatorModels models;
    private final DecisionRows decisions;
    private final MissionPhases phases;
    private final ReadingRows readings = new ReadingRows();
    private final Map<String, Table> tables = new LinkedHashMap<>();
    private final Map<String, List<Object>> madeOf = new LinkedHashMap<>();
    private long boatsAtMillis = Long.MIN_VALUE / 2;
    private Registration steps = () -> {};

    /**
     * The tables of a session.
     *
     * @param thread on which this is used
     */
    public SessionRows(Session session, Executor thread) {
        this.session = session;
        models = session.models();
        decisions = new DecisionRows(session.setup().vocabulary().types());
        phases = new MissionPhases(session.setup().vocabulary(), thread);
    }

    /** Follows the session's steps from now on; before the session begins. */
    public void start() {
        steps = session.addListener(phases);
    }

    @Override
    public void close() {
        steps.close();
    }

    /**
     * Looks at the models.
     *
     * @param drivers who claims a boat, by boat
     */
    public void look(long nowMillis, Map<String, String> drivers) {
        List<BoatSnapshot> boats = models.fleet().snapshot();
        List<Alarm> alarms = models.alarms().snapshot();
        MapSnapshot map = models.map().snapshot();
        Health health = models.health().snapshot();
        if (nowMillis - boatsAtMillis >= Math.max(BOATS_MS, MS_PER_BOAT * boats.size())) {
            boatsAtMillis = nowMillis;
            put(BoatRows.boats(boats, models.unreached().snapshot(), alarms, drivers));
            put(BoatRows.paths(map));
        }
        readings.look(models.map()::readings, nowMillis).ifPresent(this::put);
        remake(
                "settings",
                List.of(boats.stream().map(BoatSnapshot::settings).toList()),
                () -> BoatRows.settings(boats));
        remake(
                "missions",
                List.of(models.missions().snapshot()),
                () -> SituationRows.missions(models.missions().snapshot()));
        put(phases.table());
        remake(
                "pictures",
                List.of(models.pictures().snapshot()),
                () -> PictureTable.of(models.pictures().snapshot()));
        remake(
                "stuck",
                List.of(models.missions().snapshot()),
                () -> SituationRows.stuck(models.missions().snapshot()));
        remake(
                "unreached",
                List.of(models.unreached().snapshot()),
                () -> SituationRows.unreached(models.unreached().snapshot()));
        remake(
                "buttons",
                List.of(models.interrupts().snapshot()),
                () -> SituationRows.buttons(models.interrupts().snapshot()));
        remake(
                "messages",
                List.of(models.messages().snapshot()),
                () -> SituationRows.messages(models.messages().snapshot()));
        remake(
                "standings",
                List.of(models.communication().snapshot()),
                () -> SituationRows.standings(models.communication().snapshot()));
        remake("alarms", List.of(alarms), () -> SituationRows.alarms(alarms));
        remake("faults", List.of(health), () -> SituationRows.faults(health));
        remake("areas", List.of(map.areas(), map.places()), () -> SituationRows.areas(map));
        put(SituationRows.fleet(models.fleetStop().snapshot(), health, boats.size()));
    }

    private void remake(String name, List<Object> of, Supplier<Table> made) {
        List<Object> before = madeOf.put(name, of);
        if (before == null || !before.equals(of)) {
            put(made.get());
        }
    }

    private void put(Table table) {
        tables.put(table.name(), table);
    }

    /** The tables as they were looked at last, for one person. */
    public List<Table> tables(Person person) {
        List<Table> all = new ArrayList<>(tables.values());
        List<PendingDecision> pending = models.decisions().pending();
        all.add(decisions.table(pending, person));
        return all;
    }
}
