package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.crw.markup.MarkedEvent;
import org.sami.crw.operator.boat.BoatCommunication;
import org.sami.crw.operator.boat.BoatCommunication.InMission;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.ProxyStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.NaturalOrder;

/**
 * How every boat stands, the worst first: the summary of the thesis's Communication Frame (5.2.1, 6.3.4). A mission's status of a boat is
 * the last that one of its events with the markup Proxy Status said, until the mission ends or the boat is dropped from it.
 */
public final class CommunicationModel extends Model<List<BoatCommunication>> {
    private static final String MARKUP = "ProxyStatus";
    private static final Comparator<BoatCommunication> ORDER = Comparator.comparing(BoatCommunication::status)
            .reversed()
            .thenComparing(boat -> boat.link() != LinkState.LOST)
            .thenComparing(BoatCommunication::boat, NaturalOrder.INSTANCE);

    private final Map<String, Map<Long, InMission>> said = new TreeMap<>(); // by boat and mission
    private final Map<String, BoatSnapshot> boats = new TreeMap<>();

    CommunicationModel() {
        super(List.of());
    }

    void seen(BoatSnapshot boat) {
        BoatSnapshot before = boats.put(boat.boat(), boat);
        if (before == null
                || before.link() != boat.link()
                || !before.heardAtMillis().equals(boat.heardAtMillis())) {
            change();
        }
    }

    void gone(String boat) {
        boats.remove(boat);
        said.remove(boat);
        change();
    }

    /** Forgets all. */
    void clear() {
        boats.clear();
        said.clear();
        change();
    }

    void apply(EngineStep step) {
        step.marked().forEach(event -> came(event, step.atMillis()));
        if (step.input() instanceof Input.ProxyDropped dropped) {
            leaves(dropped.proxy(), dropped.mission());
        }
        for (Effect effect : step.effects()) {
            if (effect instanceof Effect.MissionEnded over && over.outcome() != Outcome.HALTED) {
                said.values().forEach(missions -> missions.remove(over.mission()));
                change();
            }
        }
    }

    private void leaves(String boat, long mission) {
        if (mission == Ids.NONE) {
            said.remove(boat);
        } else if (said.containsKey(boat)) {
            said.get(boat).remove(mission);
        }
        change();
    }

    /** Takes up the events whose visits go on in a state that was restored. */
    void restore(List<MarkedEvent> open, long atMillis) {
        open.forEach(event -> came(event, atMillis));
    }

    private void came(MarkedEvent event, long atMillis) {
        event.reader().constant(MARKUP, "status", ProxyStatus.class).ifPresent(status -> {
            for (String boat : event.boats()) {
                Map<Long, InMission> missions = said.computeIfAbsent(boat, id -> new TreeMap<>());
                InMission before = missions.get(event.mission());
                long since = before != null && before.status() == status ? before.sinceMillis() : atMillis;
                missions.put(event.mission(), new InMission(event.mission(), status, event.type(), since));
            }
            change();
        });
    }

    @Override
    List<BoatCommunication> take() {
        Set<String> names = new TreeSet<>(boats.keySet());
        said.forEach((boat, missions) -> {
            if (!missions.isEmpty()) {
                names.add(boat);
            }
        });
        List<BoatCommunication> all = new ArrayList<>();
        names.forEach(boat -> all.add(of(boat)));
        all.sort(ORDER);
        return all;
    }

    private BoatCommunication of(String boat) {
        List<InMission> missions = List.copyOf(said.getOrDefault(boat, Map.of()).values());
        Optional<BoatSnapshot> known = Optional.ofNullable(boats.get(boat));
        return new BoatCommunication(
                boat,
                missions.stream()
                        .map(InMission::status)
                        .max(Comparator.naturalOrder())
                        .orElse(ProxyStatus.NOMINAL),
                missions,
                known.map(BoatSnapshot::link).orElse(LinkState.CONNECTING),
                known.map(BoatSnapshot::heardAtMillis).orElse(OptionalLong.empty()));
    }
}
