package org.sami.crw.cli.vehicle;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.MavlinkLinkState;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.CommandedVehicles;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** What {@code crw vehicles} prints. */
final class VehicleText {
    private static final int LAST_TEXTS = 5;
    private static final double MS = 1000;
    private static final int PERCENT = 100;

    private final long nowMs;

    VehicleText(long nowMs) {
        this.nowMs = nowMs;
    }

    /** A row for each vehicle. */
    String table(List<VehicleSnapshot> vehicles) {
        if (vehicles.isEmpty()) {
            return "no vehicle was heard\n";
        }
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("id", "kind", "autopilot", "mode", "armed", "position", "speed", "battery", "GPS", "heard"));
        vehicles.forEach(vehicle -> rows.add(row(vehicle)));
        return aligned(rows);
    }

    /** Why some are not commanded from here. */
    static String notCommanded(List<VehicleSnapshot> vehicles) {
        return vehicles.stream()
                .flatMap(vehicle -> CommandedVehicles.whyNot(vehicle).stream())
                .map(why -> why + "\n")
                .collect(Collectors.joining());
    }

    private List<String> row(VehicleSnapshot vehicle) {
        return List.of(
                vehicle.id().toString(),
                vehicle.kind().word(),
                vehicle.autopilot(),
                vehicle.mode(),
                vehicle.armed() ? "armed" : "no",
                vehicle.located()
                        ? vehicle.position()
                                .map(at -> format("%.6f, %.6f", at.latDeg(), at.lonDeg()))
                                .orElse("-")
                        : "not known yet",
                vehicle.position().map(at -> format("%.1f m/s", at.speedMps())).orElse("-"),
                battery(vehicle),
                vehicle.gps()
                        .map(gps -> gps.fix()
                                + gps.satellites()
                                        .map(all -> ", " + all + " sat")
                                        .orElse(""))
                        .orElse("-"),
                format("%.1f s ago", (nowMs - vehicle.heardMs()) / MS));
    }

    private static String battery(VehicleSnapshot vehicle) {
        return vehicle.battery()
                .map(battery -> {
                    List<String> words = new ArrayList<>();
                    battery.percent().ifPresent(percent -> words.add(percent + " %"));
                    battery.volts().ifPresent(volts -> words.add(format("%.1f V", volts)));
                    return words.isEmpty() ? "-" : String.join(", ", words);
                })
                .orElse("-");
    }

    /** A line for each link. */
    String links(List<MavlinkLinkReport> links, List<VehicleSnapshot> vehicles) {
        return links.stream().map(link -> line(link, vehicles) + "\n").collect(Collectors.joining());
    }

    /** Over which link each vehicle on several is commanded, and how it is heard on the others. */
    static String ways(List<VehicleSnapshot> vehicles) {
        return vehicles.stream()
                .filter(vehicle -> vehicle.heardOn().size() > 1)
                .map(vehicle -> format(
                        "%s is commanded over %s%n",
                        vehicle.id(),
                        vehicle.heardOn().stream()
                                .map(heard -> format("%s (%.1f %% of it lost)", heard.link(), heard.lost() * PERCENT))
                                .collect(Collectors.joining("; ready is "))))
                .collect(Collectors.joining());
    }

    private static String line(MavlinkLinkReport link, List<VehicleSnapshot> vehicles) {
        StringBuilder line = new StringBuilder(link.address().toString()).append(": ");
        if (link.state() != MavlinkLinkState.OPEN) {
            return line.append(link.fault().orElse("it is not open yet")).toString();
        }
        line.append(format("%d messages, %.1f %% lost", link.messages(), link.lost() * PERCENT));
        link.rssi().ifPresent(rssi -> line.append(", radio ").append(rssi).append(" here"));
        link.remoteRssi().ifPresent(rssi -> line.append(", ").append(rssi).append(" there"));
        link.refused()
                .forEach((why, many) ->
                        line.append(format("; refused %d message%s %s", many, many == 1 ? "" : "s", why.words())));
        link.fault().ifPresent(fault -> line.append("; ").append(fault));
        if (link.fault().isEmpty()) {
            link.senders().forEach((system, fault) -> line.append(format("; vehicle %d %s", system, fault.words())));
        }
        if (link.fault().isEmpty() && !isHeard(link, vehicles)) {
            line.append(
                    link.bytes() == 0
                            ? "; nothing came: is this the port on which the vehicle speaks MAVLink, and is it on?"
                            : !link.refused().isEmpty() ? "" : "; no vehicle speaks on it");
        }
        return line.toString();
    }

    /** Whether a link brought a vehicle. */
    static boolean isHeard(MavlinkLinkReport link, List<VehicleSnapshot> vehicles) {
        return vehicles.stream().anyMatch(vehicle -> vehicle.links().contains(link.address()));
    }

    /** What the vehicles have said last, in their own words. */
    String said(List<VehicleSnapshot> vehicles) {
        StringBuilder text = new StringBuilder();
        for (VehicleSnapshot vehicle : vehicles) {
            List<StatusText> texts = vehicle.texts();
            texts.subList(Math.max(0, texts.size() - LAST_TEXTS), texts.size())
                    .forEach(said -> text.append(format(
                            "%s says (%s): %s%n",
                            vehicle.id(), said.severity().name().toLowerCase(Locale.ROOT), said.text())));
        }
        return text.toString();
    }

    /** What vehicles say is wrong with them. */
    static String faults(List<VehicleSnapshot> vehicles) {
        return vehicles.stream()
                .filter(vehicle -> !vehicle.health().failing().isEmpty())
                .map(vehicle -> format(
                        "%s has a fault: %s%n",
                        vehicle.id(), String.join(", ", vehicle.health().failing())))
                .collect(Collectors.joining());
    }

    /** What a vehicle holds of a kind. */
    static String held(VehicleSnapshot vehicle, HeldKind kind, List<MissionItem> items) {
        if (items.isEmpty()) {
            return format("%s holds no %s%n", vehicle.id(), kind.words());
        }
        StringBuilder text = new StringBuilder(format("%s holds this %s:%n", vehicle.id(), kind.words()));
        List<List<String>> rows = new ArrayList<>();
        for (MissionItem item : items) {
            rows.add(List.of(
                    "  " + item.number(),
                    item.commandName(),
                    place(item).orElse(""),
                    format("%.1f m", item.heightM())));
        }
        return text.append(aligned(rows)).toString();
    }

    private static Optional<String> place(MissionItem item) {
        return item.latDeg() == 0 && item.lonDeg() == 0
                ? Optional.empty()
                : Optional.of(format("%.6f, %.6f", item.latDeg(), item.lonDeg()));
    }

    private static String aligned(List<List<String>> rows) {
        int columns = rows.get(0).size();
        int[] widths = new int[columns];
        for (List<String> row : rows) {
            for (int i = 0; i < columns; i++) {
                widths[i] = Math.max(widths[i], row.get(i).length());
            }
        }
        StringBuilder text = new StringBuilder();
        for (List<String> row : rows) {
            StringBuilder line = new StringBuilder();
            for (int i = 0; i < columns; i++) {
                line.append(row.get(i)).append(" ".repeat(widths[i] - row.get(i).length() + 2));
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        return text.toString();
    }

    private static String format(String form, Object... values) {
        return String.format(Locale.ROOT, form, values);
    }
}
