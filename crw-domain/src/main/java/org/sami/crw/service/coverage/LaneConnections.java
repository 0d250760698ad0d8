package org.sami.crw.service.coverage;

import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.sami.crw.service.path.VisibilityGraph;

/** Ways between lanes: straight where that enters nothing forbidden, else the shortest. */
final class LaneConnections {
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final Geometry forbidden;
    private final PreparedGeometry prepared;
    private Optional<VisibilityGraph> graph = Optional.empty();

    /** Ways that stay out of polygons on the plane. */
    LaneConnections(Geometry forbidden) {
        this.forbidden = forbidden;
        prepared = PreparedGeometryFactory.prepare(forbidden);
    }

    /** The places of the shortest way with both its ends; empty where there is none. */
    Optional<List<Coordinate>> between(Coordinate from, Coordinate to) {
        if (from.equals2D(to) || !prepared.intersects(FACTORY.createLineString(new Coordinate[] {from, to}))) {
            return Optional.of(List.of(from, to));
        }
        if (graph.isEmpty()) {
            graph = Optional.of(new VisibilityGraph(forbidden, 0));
        }
        return graph.get().shortest(from, to);
    }
}
