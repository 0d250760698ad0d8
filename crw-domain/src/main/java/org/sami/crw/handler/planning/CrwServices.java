package org.sami.crw.handler.planning;

import java.util.Objects;
import org.sami.crw.service.allocation.AllocationService;
import org.sami.crw.service.coverage.CoverageAlgorithm;
import org.sami.crw.service.coverage.LawnMower;
import org.sami.crw.service.path.PathService;
import org.sami.crw.service.placement.AssemblyAlgorithm;
import org.sami.crw.service.placement.HexagonalAssembly;
import org.sami.crw.service.water.CrossTrackError;

/**
 * The services that the handlers use.
 *
 * @param error cross-track error of boats that do not report theirs: all ways keep that distance from no-go areas
 */
public record CrwServices(
        AllocationService allocation,
        PathService paths,
        AssemblyAlgorithm assembly,
        CoverageAlgorithm coverage,
        CrossTrackError error) {
    /** All algorithms that there are. */
    public static final CrwServices STANDARD =
            new CrwServices(AllocationService.STANDARD, PathService.STANDARD, new HexagonalAssembly(), new LawnMower());

    /** Services for boats in still water whose instruments are exact. */
    public CrwServices(
            AllocationService allocation, PathService paths, AssemblyAlgorithm assembly, CoverageAlgorithm coverage) {
        this(allocation, paths, assembly, coverage, CrossTrackError.CALM);
    }

    public CrwServices {
        Objects.requireNonNull(allocation, "allocation");
        Objects.requireNonNull(paths, "paths");
        Objects.requireNonNull(assembly, "assembly");
        Objects.requireNonNull(coverage, "coverage");
        Objects.requireNonNull(error, "error");
    }

    /** The same for boats with another cross-track error. */
    public CrwServices drivenWith(CrossTrackError other) {
        return new CrwServices(allocation, paths, assembly, coverage, other);
    }
}
