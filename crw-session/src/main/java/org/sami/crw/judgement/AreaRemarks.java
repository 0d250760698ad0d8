package org.sami.crw.judgement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.Polygon;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement.Remark;
import org.sami.spn.value.GeoArea;

/** What of an area boats may not enter, and what becomes of that part. */
final class AreaRemarks {
    private static final String EXPLORE = "ProxyExploreArea";
    private static final String DISTRIBUTE = "DistributeLocationsRequest";

    /** A smaller part is not spoken of: whoever draws along an edge crosses it by a hair. */
    private static final double LEAST = 0.001;

    private final JudgedQuestion question;
    private final List<Remark> remarks = new ArrayList<>();

    private AreaRemarks(JudgedQuestion question) {
        this.question = question;
    }

    /** The remarks on an area that an item of the question gives. */
    static List<Remark> of(String item, GeoArea area, JudgedQuestion question, DraftAnswer draft) {
        AreaRemarks all = new AreaRemarks(question);
        all.judge(item, area, draft);
        return all.remarks;
    }

    private void judge(String item, GeoArea area, DraftAnswer draft) {
        LocalPlane plane = new LocalPlane(area.outline().get(0));
        Polygon drawn;
        try {
            drawn = Areas.polygon(area, plane, "The area");
        } catch (IllegalArgumentException crossed) {
            remarks.add(Remark.refusal(String.valueOf(crossed.getMessage())));
            return;
        }
        if (question.isLimit(item)) {
            return;
        }
        List<JudgedRequest> work = question.requests().stream()
                .filter(request ->
                        request.type().equals(EXPLORE) || request.type().equals(DISTRIBUTE))
                .filter(request -> !request.fieldsOf(item).isEmpty())
                .toList();
        Optional<GeoArea> kept = work.stream()
                .flatMap(request -> Optional.ofNullable(request.values(draft).get(JudgedRequest.WITHIN)).stream())
                .filter(GeoArea.class::isInstance)
                .map(GeoArea.class::cast)
                .findFirst();
        Geometry allowed = drawn;
        Optional<GeoArea> stay = kept.or(question::stay);
        Optional<Geometry> within = stay.flatMap(one -> polygon(one, plane));
        if (within.isPresent()) {
            allowed = drawn.intersection(within.get());
            outside(1 - allowed.getArea() / drawn.getArea(), question.name(stay.get()), kept.isPresent(), work);
        }
        double outside = allowed.getArea();
        for (GeoArea avoid : question.limits().avoid()) {
            Optional<Geometry> out = polygon(avoid, plane);
            if (out.isPresent()) {
                allowed = allowed.difference(out.get());
            }
        }
        avoided((outside - allowed.getArea()) / drawn.getArea(), allowed.getArea() / drawn.getArea(), work);
    }

    private void outside(double part, String fence, boolean kept, List<JudgedRequest> work) {
        if (part < LEAST) {
            return;
        }
        if (part > 1 - LEAST) {
            remarks.add(
                    kept
                            ? Remark.refusal("The whole area is outside " + fence + ": nothing of it is left")
                            : Remark.doubt("The whole area is outside " + fence));
            return;
        }
        String becomes = kept ? " and will be left out" : work.isEmpty() ? "" : ", and boats will be sent there";
        remarks.add(Remark.doubt(Amounts.percent(part) + " of the area is outside " + fence + becomes));
    }

    private void avoided(double part, double left, List<JudgedRequest> work) {
        if (part < LEAST) {
            return;
        }
        if (left < LEAST) {
            String words = "Nothing of the area is left without what lies in " + question.avoided();
            remarks.add(work.isEmpty() ? Remark.doubt(words) : Remark.refusal(words));
            return;
        }
        remarks.add(Remark.doubt(Amounts.percent(part) + " of the area lies in " + question.avoided()
                + (work.isEmpty() ? "" : " and will be left out")));
    }

    /** Empty for an area that is no simple polygon: an alarm of its own. */
    private static Optional<Geometry> polygon(GeoArea area, LocalPlane plane) {
        try {
            return Optional.of(Areas.polygon(area, plane, "An area"));
        } catch (IllegalArgumentException crossed) {
            return Optional.empty();
        }
    }
}
