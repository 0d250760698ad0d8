package org.sami.ui.map;

import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;

/** Vehicles as seen from above with their heading, a line to where they will be in ten seconds, and their short names. */
public final class VehicleLayer extends MapLayer {
    private static final double REACH_PX = 16;

    private final VehicleHulls hulls;
    private final VehicleNames names = new VehicleNames();
    private List<ShownVehicle> vehicles = List.of();

    /** A layer of hulls. */
    public VehicleLayer(String id, String title) {
        this(id, title, VehicleShape.HULL);
    }

    public VehicleLayer(String id, String title, VehicleShape form) {
        this(id, title, vehicle -> form);
    }

    /**
     * A layer of vehicles of several kinds.
     *
     * @param forms what each looks like, by its id
     */
    public VehicleLayer(String id, String title, Function<String, VehicleShape> forms) {
        super(id, title);
        hulls = new VehicleHulls(forms);
    }

    /** Shows these vehicles instead of those before; later ones lie on top. */
    public void show(List<ShownVehicle> vehicles) {
        this.vehicles = List.copyOf(vehicles);
        changed();
    }

    /** What is shown. */
    public List<ShownVehicle> vehicles() {
        return vehicles;
    }

    @Override
    protected void paint(MapPaint paint) {
        vehicles.stream()
                .filter(vehicle -> isNear(paint.frame(), vehicle, VehicleHulls.reachPx(paint, vehicle)))
                .forEach(vehicle -> paint.paint(vehicle.id(), () -> hulls.paint(paint, vehicle)));
    }

    @Override
    protected void paintNames(MapPaint paint) {
        names.paint(
                paint,
                vehicles.stream()
                        .filter(vehicle -> isNear(paint.frame(), vehicle, VehicleHulls.halfPx()))
                        .toList());
    }

    private static boolean isNear(MapFrame frame, ShownVehicle vehicle, double px) {
        double x = frame.px(vehicle.at());
        double y = frame.py(vehicle.at());
        return x >= -px && y >= -px && x <= frame.width() + px && y <= frame.height() + px;
    }

    /** Where hulls are on a map, in pixels. */
    List<Rectangle2D> boxes(MapFrame frame) {
        double half = VehicleHulls.halfPx();
        return vehicles.stream()
                .filter(vehicle -> isNear(frame, vehicle, half))
                .<Rectangle2D>map(vehicle -> new Rectangle2D.Double(
                        frame.px(vehicle.at()) - half, frame.py(vehicle.at()) - half, 2 * half, 2 * half))
                .toList();
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return GeoBounds.of(vehicles.stream().map(ShownVehicle::at).toList());
    }

    @Override
    public Optional<String> itemAt(MapFrame frame, double px, double py) {
        return vehicles.stream()
                .filter(vehicle -> frame.distancePx(vehicle.at(), px, py) <= Painting.px(REACH_PX))
                .min(Comparator.comparingDouble(vehicle -> frame.distancePx(vehicle.at(), px, py)))
                .map(ShownVehicle::id);
    }

    @Override
    public void offer(Snapping snapping) {
        vehicles.forEach(vehicle -> snapping.addCorner(vehicle.at()));
    }
}
