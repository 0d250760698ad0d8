package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.QuantityComparison;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Compare Distance Request: how far each boat is from its point, against a threshold; one answer per boat. The boat's distance
 * is the first quantity (appendix .2.2). Equal is what differs by a millimetre at most: plans that treat it as a case of
 * its own need not meet it by chance.
 */
public final class CompareDistanceHandler implements ActivationHandler {
    public static final String TYPE = "ProxyCompareDistanceRequest";
    private static final double TOLERANCE_M = 0.001;

    private final BoatPositions positions;

    public CompareDistanceHandler(BoatPositions positions) {
        this.positions = positions;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Map<String, GeoPoint> points =
                ProxyMaps.read(ActivationFields.required(activation, "location"), GeoPoint.class);
        double thresholdM = ActivationFields.metres(activation, "distance");
        List<Input> answers = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            Optional<GeoPoint> position = positions.positionOf(addressee.boat());
            GeoPoint point = points.get(addressee.boat());
            if (point == null) {
                problems.add("there is no location to compare " + addressee.boat() + " with");
            } else if (position.isEmpty()) {
                problems.add("the position of " + addressee.boat() + " is not known yet");
            } else {
                double distanceM = Geodesy.distanceM(position.get(), point);
                String type = answer(QuantityComparison.of(distanceM, thresholdM, TOLERANCE_M));
                answers.add(new Input.Received(addressee.answer(type, activation, Map.of())));
            }
        }
        if (!answers.isEmpty()) {
            context.post(answers);
        }
        if (!problems.isEmpty()) {
            throw new IllegalStateException(String.join("; ", problems));
        }
    }

    private static String answer(QuantityComparison comparison) {
        return switch (comparison) {
            case GREATER -> EventNames.QUANTITY_GREATER;
            case LESS -> EventNames.QUANTITY_LESS;
            case EQUAL -> EventNames.QUANTITY_EQUAL;
        };
    }
}
