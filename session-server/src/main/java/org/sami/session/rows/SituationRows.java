package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.BoatCommunication;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.crw.operator.boat.ProxyStatus;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.NamedArea;
import org.sami.crw.operator.map.ShownPlace;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.spn.protocol.Ids;

/** Rows of missions, buttons, messages, alarms, faults, areas and the fleet. */
final class SituationRows {
    private static final int MOST = 200;
    private static final int MOST_BUTTONS = 500;
    private static final int MOST_AREAS = 300;

    private SituationRows() {}

    static Table missions(MissionsSnapshot snapshot) {
        Table.Builder table = new Table.Builder("missions", MOST);
        List<MissionSnapshot> all = snapshot.missions();
        for (MissionSnapshot mission : all.subList(Math.max(0, all.size() - MOST), all.size())) {
            ObjectNode row = table.row(String.valueOf(mission.id()));
            mission(row, "parent", mission.parent());
            row.put("name", Table.Builder.cut(mission.words()));
            row.put("plan", mission.plan());
            row.put("state", mission.outcome().map(BoatRows::word).orElse("running"));
            Table.Builder.ids(row, "places", mission.marking().keySet());
            mission.stuck().ifPresent(stuck -> row.put("stuck", Table.Builder.cut(stuck.what() + ". " + stuck.help())));
            row.put("since", mission.startedAtMillis());
            mission.endedAtMillis().ifPresent(at -> row.put("ended", at));
        }
        return table.build();
    }

    private static void mission(ObjectNode row, String member, long mission) {
        if (mission != Ids.NONE) {
            row.put(member, String.valueOf(mission));
        }
    }

    static Table buttons(List<InterruptChoice> choices) {
        Table.Builder table = new Table.Builder("buttons", MOST_BUTTONS);
        for (InterruptChoice choice : choices) {
            ObjectNode row = table.row(choice.mission() + "/" + choice.name());
            row.put("mission", String.valueOf(choice.mission()));
            row.put("plan", choice.plan());
            row.put("name", choice.name());
            row.put("description", Table.Builder.cut(choice.description()));
            row.put("priority", BoatRows.word(choice.priority()));
            row.put("boats", choice.asksForBoats());
            Table.Builder.put(row, "whyNot", choice.whyNot());
            Table.Builder.put(row, "final", choice.noWayBack());
        }
        return table.build();
    }

    static Table messages(List<MessageEntry> entries) {
        Table.Builder table = new Table.Builder("messages", MOST);
        for (MessageEntry entry : entries) {
            int rank = table.size();
            ObjectNode row = table.row(String.valueOf(entry.number()));
            row.put("rank", rank);
            row.put("at", entry.message().atMillis());
            row.put("priority", BoatRows.word(entry.message().priority()));
            row.put("text", Table.Builder.cut(entry.message().text()));
            Table.Builder.ids(row, "boats", entry.message().boats());
            mission(row, "mission", entry.message().mission());
            row.put("acknowledged", entry.acknowledged());
            row.put("count", entry.count());
            row.put("source", BoatRows.word(entry.message().source()));
            Table.Builder.put(row, "keyword", entry.message().keyword());
            entry.message()
                    .map()
                    .boats()
                    .filter(MapRelevance.Boats::showPictures)
                    .ifPresent(shown -> Table.Builder.ids(row, "pictures", shown.boats()));
        }
        return table.build();
    }

    /** How boats stand in missions, by the markup Proxy Status; those that stand well are left out. */
    static Table standings(List<BoatCommunication> boats) {
        Table.Builder table = new Table.Builder("standings", BoatRows.MOST_BOATS);
        for (BoatCommunication boat : boats) {
            if (boat.status() != ProxyStatus.NOMINAL) {
                table.row(boat.boat()).put("status", BoatRows.word(boat.status()));
            }
        }
        return table.build();
    }

    static Table alarms(List<Alarm> alarms) {
        Table.Builder table = new Table.Builder("alarms", MOST);
        for (Alarm alarm : alarms) {
            int rank = table.size();
            ObjectNode row = table.row(String.valueOf(alarm.number()));
            row.put("rank", rank);
            row.put("kind", BoatRows.word(alarm.kind()));
            row.put("severity", BoatRows.word(alarm.kind().severity()));
            row.put("text", Table.Builder.cut(alarm.text()));
            row.put("advice", alarm.kind().advice());
            Table.Builder.put(row, "boat", alarm.boat());
            Table.Builder.put(row, "other", alarm.other());
            row.put("since", alarm.sinceMillis());
            row.put("active", alarm.active());
            row.put("acknowledged", alarm.acknowledged());
            row.put("sounds", alarm.sounds());
        }
        return table.build();
    }

    static Table faults(Health health) {
        Table.Builder table = new Table.Builder("faults", MOST);
        for (HealthEntry entry : health.entries()) {
            int rank = table.size();
            table.row(String.valueOf(entry.number()))
                    .put("rank", rank)
                    .put("severity", BoatRows.word(entry.severity()))
                    .put("text", Table.Builder.cut(entry.fault().text()))
                    .put("advice", Table.Builder.cut(entry.fault().advice()))
                    .put("since", entry.sinceMillis())
                    .put("kind", BoatRows.word(entry.fault().kind()))
                    .put("subject", entry.fault().subject())
                    .put("details", Table.Builder.cut(entry.fault().details()))
                    .put("boat", entry.fault().boat())
                    .put("mission", String.valueOf(entry.fault().mission()));
        }
        return table.build();
    }

    static Table stuck(MissionsSnapshot snapshot) {
        Table.Builder table = new Table.Builder("stuck", MOST);
        List<StuckMission> all = snapshot.missions().stream()
                .flatMap(mission -> mission.stuck().stream())
                .distinct()
                .toList();
        for (StuckMission stuck : all) {
            ObjectNode row = table.row(String.valueOf(stuck.mission()));
            row.put("root", String.valueOf(stuck.root()));
            row.put("title", Table.Builder.cut(stuck.title()));
            row.put("since", stuck.sinceMillis());
            row.put("what", Table.Builder.cut(stuck.what()));
            row.put("help", Table.Builder.cut(stuck.help()));
            Table.Builder.ids(row, "boats", stuck.boats());
            row.put("again", stuck.canBeSentAgain());
        }
        return table.build();
    }

    static Table unreached(List<UnreachedBoat> all) {
        Table.Builder table = new Table.Builder("unreached", MOST);
        for (UnreachedBoat one : all) {
            ObjectNode row = table.row(one.address());
            Table.Builder.put(row, "boat", one.boat());
            row.put("reason", Table.Builder.cut(one.reason()));
            row.put("refused", one.refused());
            row.put("tries", one.tries());
            row.put("since", one.sinceMillis());
        }
        return table.build();
    }

    static Table areas(MapSnapshot map) {
        Table.Builder table = new Table.Builder("areas", MOST_AREAS);
        int number = 0;
        for (NamedArea area : map.areas()) {
            ObjectNode row = table.row("a" + number++);
            row.put(
                    "kind",
                    switch (area.layer()) {
                        case NO_GO -> "no-go";
                        case FENCE -> "fence";
                        case RELEVANT_AREA -> "relevant";
                        default -> "area";
                    });
            row.put("name", area.name());
            mission(row, "mission", area.mission());
            row.set("shape", Shapes.area(area.area()));
        }
        for (ShownPlace place : map.places()) {
            ObjectNode row = table.row("a" + number++);
            row.put("kind", "place");
            row.put("name", place.name());
            mission(row, "mission", place.mission());
            row.set("shape", Shapes.place(place.point()));
        }
        return table.build();
    }

    static Table fleet(FleetStopState stop, Health health, int boats) {
        Table.Builder table = new Table.Builder("fleet", 1);
        table.row("fleet")
                .put("stopped", stop.isOfFleet())
                .put("every", stop.everyBoat())
                .put("words", Table.Builder.cut(stop.words()))
                .put("advice", stop.isLatched() ? Table.Builder.cut(stop.advice()) : "")
                .put("boats", boats)
                .put("standStill", health.missionsStandStill());
        return table.build();
    }
}
