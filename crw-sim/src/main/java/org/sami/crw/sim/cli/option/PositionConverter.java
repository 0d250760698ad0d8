package org.sami.crw.sim.cli.option;

import org.sami.spn.value.GeoPoint;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads a WGS 84 position, latitude and longitude in degrees with a comma between. */
public final class PositionConverter implements ITypeConverter<GeoPoint> {
    private static final double MOST_LAT_DEG = 85; // hulls move on a plane, which the poles do not have

    @Override
    public GeoPoint convert(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length == 2) {
            try {
                double latDeg = Double.parseDouble(parts[0].trim());
                double lonDeg = Double.parseDouble(parts[1].trim());
                if (Math.abs(latDeg) <= MOST_LAT_DEG && Math.abs(lonDeg) <= 180) {
                    return GeoPoint.of(latDeg, lonDeg);
                }
            } catch (NumberFormatException e) {
                // said below
            }
        }
        throw new TypeConversionException(
                "expected is LAT,LON in degrees, at most 85 and 180, such as 45.4,10.9, not '" + text + "'");
    }
}
