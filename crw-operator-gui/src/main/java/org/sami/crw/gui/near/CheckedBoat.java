package org.sami.crw.gui.near;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.gui.boat.BoatWords;
import org.sami.crw.gui.boat.LaunchWords;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.LaunchCheck;
import org.sami.crw.operator.alarm.LaunchCheck.State;
import org.sami.crw.operator.alarm.LaunchFacts;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.session.near.NearList;
import org.sami.crw.session.near.NearRow;
import org.sami.palette.SemanticColor;

/** A boat near as a row shows it: with its check, if the session knows it. */
record CheckedBoat(NearRow row, Optional<BoatSnapshot> known, Optional<LaunchCheck> check) {
    /** The boats of a list, those with problems first: in a low window the others may not be visible. */
    static List<CheckedBoat> of(NearList list, OperatorModels models, LaunchFacts facts) {
        return list.rows().stream()
                .map(row -> of(row, models, facts))
                .sorted(Comparator.comparingInt(CheckedBoat::trouble).reversed())
                .toList();
    }

    private int trouble() {
        return switch (row.state()) {
            case FAILING -> 3;
            case CONNECTING -> 0;
            case NONE -> row.advice().isEmpty() ? 0 : 2;
            case CONNECTED ->
                switch (check.map(LaunchCheck::overall).orElse(State.UNKNOWN)) {
                    case BAD -> 3;
                    case DOUBTFUL, UNKNOWN -> 1;
                    case GOOD -> 0;
                };
        };
    }

    private static CheckedBoat of(NearRow row, OperatorModels models, LaunchFacts facts) {
        Optional<BoatSnapshot> known = row.boat().flatMap(models.fleet()::boat);
        return new CheckedBoat(row, known, known.map(boat -> LaunchCheck.of(boat, OptionalDouble.empty(), facts)));
    }

    String name() {
        return row.name();
    }

    String battery() {
        return known.map(BoatWords::battery).orElseGet(row::announcedBattery);
    }

    boolean isConnected() {
        return row.state() == NearRow.Link.CONNECTED;
    }

    boolean isReady() {
        return isConnected() && check.filter(LaunchCheck::isReady).isPresent();
    }

    /** Of a boat that is not connected, what connects it. */
    String checkWords() {
        return isConnected() ? check.map(LaunchWords::line).orElse("") : row.advice();
    }

    SemanticColor checkColor() {
        return check.filter(one -> isConnected())
                .map(one -> LaunchWords.color(one.overall()))
                .orElse(SemanticColor.MUTED);
    }

    SemanticColor linkColor() {
        return switch (row.state()) {
            case CONNECTED, CONNECTING -> SemanticColor.TEXT;
            case FAILING -> SemanticColor.WARNING;
            case NONE -> row.canConnect() ? SemanticColor.TEXT : SemanticColor.MUTED;
        };
    }

    /** Such as {@code 20 boats · 18 connected · 17 ready}. */
    static String count(List<CheckedBoat> boats) {
        long connected = boats.stream().filter(CheckedBoat::isConnected).count();
        long ready = boats.stream().filter(CheckedBoat::isReady).count();
        return boats.size() + (boats.size() == 1 ? " boat · " : " boats · ") + connected + " connected · " + ready
                + " ready";
    }
}
